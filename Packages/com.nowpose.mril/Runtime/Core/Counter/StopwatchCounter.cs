using System.Diagnostics;

namespace Nowpose.Counter
{
    /// <summary>The counter of <see cref="Stopwatch"/>. Under Mono and IL2CPP it counts 100 ns on every device.</summary>
    sealed class StopwatchCounter : ICounter
    {
        public long Frequency => Stopwatch.Frequency;

        public long Read() => Stopwatch.GetTimestamp();
    }
}
