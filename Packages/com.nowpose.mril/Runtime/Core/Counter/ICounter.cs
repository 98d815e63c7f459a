using System.Diagnostics;

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

    /// <summary>The counter of <see cref="Stopwatch"/>. Under Mono and IL2CPP it counts 100 ns on every device.</summary>
    sealed class StopwatchCounter : ICounter
    {
        public long Frequency => Stopwatch.Frequency;

        public long Read() => Stopwatch.GetTimestamp();
    }
}
