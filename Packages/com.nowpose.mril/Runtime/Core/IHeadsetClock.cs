using System;
using System.Diagnostics;

namespace Nowpose
{
    /// <summary>The headset clock C2. It never jumps or goes back; any thread may read it.</summary>
    public interface IHeadsetClock
    {
        HeadsetTime Now { get; }
    }

    /// <summary>A headset clock based on <see cref="System.Diagnostics.Stopwatch"/>, whose readings convert to headset time.</summary>
    public interface IPerformanceCounterClock : IHeadsetClock
    {
        /// <summary>Converts a reading of <see cref="System.Diagnostics.Stopwatch.GetTimestamp"/> to headset time.</summary>
        /// <param name="count">
        /// Reading in counts of <see cref="System.Diagnostics.Stopwatch.Frequency"/>. Under Mono and IL2CPP, the frequency is 10 MHz on
        /// every device; counts of QueryPerformanceCounter have another frequency.
        /// </param>
        HeadsetTime At(long count);
    }

    /// <summary>A headset clock that reads the device's monotonic high-resolution counter; the device determines the epoch.</summary>
    public sealed class StopwatchHeadsetClock : IPerformanceCounterClock
    {
        static readonly double TicksPerCount = TimeSpan.TicksPerSecond / (double)Stopwatch.Frequency;

        public HeadsetTime Now => At(Stopwatch.GetTimestamp());

        public HeadsetTime At(long count)
        {
            // Converts whole seconds separately, because the product of a large count and a fraction would lose the last digits.
            var seconds = count / Stopwatch.Frequency;
            var rest = count % Stopwatch.Frequency;
            return new HeadsetTime(new TimeSpan(seconds * TimeSpan.TicksPerSecond + (long)(rest * TicksPerCount)));
        }
    }
}
