using System;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>
    /// Waits between attempts to connect: 0.2 s doubling to 1.5 s, each varied by ±20 % so that headsets do not return
    /// all at once.
    /// </summary>
    sealed class Backoff
    {
        readonly Random _random;
        double _seconds;

        public Backoff(Random random)
        {
            _random = random;
            Reset();
        }

        public TimeSpan Next()
        {
            var jitter = 1 + ProtocolLimits.BackoffJitter * (2 * _random.NextDouble() - 1);
            var wait = ClockTicks.Span(_seconds * jitter);
            _seconds = Math.Min(_seconds * ProtocolLimits.BackoffFactor, ClockTicks.Seconds(ProtocolLimits.BackoffLongest));
            return wait;
        }

        /// <summary>The connection worked: the next failure starts with the shortest wait again.</summary>
        public void Reset() => _seconds = ClockTicks.Seconds(ProtocolLimits.BackoffFirst);
    }
}
