using System;
using System.Diagnostics;

namespace Nowpose
{
    /// <summary>Uses the device's monotonic high-resolution counter as headset clock; its epoch is the device's own.</summary>
    public sealed class StopwatchHeadsetClock : IPerformanceCounterClock
    {
        static readonly double TicksPerCount = TimeSpan.TicksPerSecond / (double)Stopwatch.Frequency;

        public HeadsetTime Now => At(Stopwatch.GetTimestamp());

        public HeadsetTime At(long count)
        {
            // Converts whole seconds separately: the product of a large count and a fraction would lose the last digits.
            var seconds = count / Stopwatch.Frequency;
            var rest = count % Stopwatch.Frequency;
            return new HeadsetTime(new TimeSpan(seconds * TimeSpan.TicksPerSecond + (long)(rest * TicksPerCount)));
        }
    }
}
