namespace Nowpose.Sync
{
    /// <summary>Turns sync exchanges into offset and skew. Not thread-safe: <see cref="ClockSynchroniser"/> sees to that.</summary>
    public interface IClockEstimator
    {
        /// <summary>The line after the newest exchange; <see cref="ClockLine.Exchanges"/> is 0 before the first.</summary>
        ClockLine Line { get; }

        /// <param name="exchange">Checked, and newer than all before.</param>
        void Add(in SyncExchange exchange);

        /// <summary>Forgets everything: the control clock stepped.</summary>
        void Reset();
    }
}
