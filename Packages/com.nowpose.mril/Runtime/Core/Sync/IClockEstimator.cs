namespace Nowpose.Sync
{
    /// <summary>Turns sync exchanges into offset and skew. Not thread-safe: <see cref="ClockSynchroniser"/> sees to that.</summary>
    interface IClockEstimator
    {
        /// <summary>The line after the newest exchange; <see cref="ClockLine.Exchanges"/> is 0 before the first.</summary>
        ClockLine Line { get; }

        /// <param name="exchange">Checked, and newer than all before.</param>
        void Add(in SyncExchange exchange);

        /// <summary>Forgets the offset: a clock stepped, or nothing was heard for long.</summary>
        /// <param name="skewDoubt">
        /// What the skew may be off from what it was, one standard deviation, dimensionless: little where the same two clocks
        /// run on. An estimator need not make use of it.
        /// </param>
        void Restart(double skewDoubt);
    }
}
