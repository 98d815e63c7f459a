using System;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>
    /// Delays between connection attempts: 0.2 s at first, doubling up to 1.5 s. Each delay has a random variation of ±20 %, so that headsets
    /// do not reconnect all at once.
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

        /// <summary>Resets to the shortest delay after a successful connection.</summary>
        public void Reset() => _seconds = ClockTicks.Seconds(ProtocolLimits.BackoffFirst);
    }
}
