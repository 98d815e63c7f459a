namespace Nowpose.Counter
{
    /// <summary>A monotonic counter of the device.</summary>
    interface ICounter
    {
        /// <summary>Counts per second; constant while the device runs. 0 if the counter does not work.</summary>
        long Frequency { get; }

        /// <summary>Reads the counter. Allocates nothing.</summary>
        long Read();
    }
}
