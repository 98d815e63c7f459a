using System;
using Nowpose.Messages;

namespace Nowpose
{
    /// <summary>Conversions between the 100 ns ticks of the time types, nanoseconds and seconds.</summary>
    static class ClockTicks
    {
        public const int NanosecondsPerTick = 100;

        /// <summary>Converts nanoseconds to ticks, rounded to the nearest tick; half a tick is rounded away from zero.</summary>
        public static long FromNanoseconds(long nanoseconds)
        {
            var half = nanoseconds < 0 ? -NanosecondsPerTick / 2 : NanosecondsPerTick / 2;
            var remainder = nanoseconds % NanosecondsPerTick;
            return nanoseconds / NanosecondsPerTick + (remainder + half) / NanosecondsPerTick;
        }

        /// <summary>
        /// Converts seconds to a <see cref="TimeSpan"/>, because <see cref="TimeSpan.FromSeconds(double)"/> rounds to milliseconds under
        /// Mono.
        /// </summary>
        public static TimeSpan Span(double seconds)
        {
            var ticks = Math.Round(seconds * TimeSpan.TicksPerSecond);
            if (!(Math.Abs(ticks) < long.MaxValue))
                throw new ArgumentOutOfRangeException(nameof(seconds), seconds, ClockMessages.SecondsOutOfRange);
            return new TimeSpan((long)ticks);
        }

        public static double Seconds(TimeSpan length) => length.Ticks / (double)TimeSpan.TicksPerSecond;
    }
}
