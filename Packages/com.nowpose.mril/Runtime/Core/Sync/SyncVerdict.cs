namespace Nowpose.Sync
{
    /// <summary>Result of adding an exchange to a <see cref="ClockSynchroniser"/>.</summary>
    enum SyncVerdict
    {
        /// <summary>The exchange was dropped because it is invalid.</summary>
        Dropped,

        /// <summary>The exchange was used.</summary>
        Consistent,

        /// <summary>The exchange contradicts recent exchanges and is set aside until a clock step is confirmed or ruled out.</summary>
        SetAside,

        /// <summary>A clock stepped: the estimator restarts with the exchanges set aside.</summary>
        Step,
    }
}
