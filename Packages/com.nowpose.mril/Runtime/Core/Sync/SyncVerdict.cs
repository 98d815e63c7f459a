namespace Nowpose.Sync
{
    /// <summary>What became of an exchange that was added to a <see cref="ClockSynchroniser"/>.</summary>
    enum SyncVerdict
    {
        /// <summary>Dropped: it broke a rule of the exchange itself.</summary>
        Dropped,

        /// <summary>Used.</summary>
        Consistent,

        /// <summary>Contradicts the recent exchanges; kept aside until it is clear whether a clock stepped.</summary>
        SetAside,

        /// <summary>A clock stepped: the estimator starts anew from the exchanges set aside.</summary>
        Step,
    }
}
