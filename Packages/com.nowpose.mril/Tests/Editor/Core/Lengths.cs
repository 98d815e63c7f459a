using System;

namespace Nowpose.Tests.Core
{
    /// <summary>Creates time spans rounded to 100 ns. The methods of <see cref="TimeSpan"/> round to whole milliseconds under Mono.</summary>
    static class Lengths
    {
        public static TimeSpan Ms(double ms) => TimeSpan.FromTicks((long)Math.Round(ms * TimeSpan.TicksPerMillisecond));

        public static TimeSpan Seconds(double seconds) => TimeSpan.FromTicks((long)Math.Round(seconds * TimeSpan.TicksPerSecond));
    }
}
