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

        /// <summary>
        /// Resets to the shortest delay if a connection has lasted long enough. Otherwise, a client would connect five times per second to a
        /// gateway that closes each connection soon after its first message.
        /// </summary>
        /// <param name="connected">Time since the connection was opened, until its newest message.</param>
        public void ResetAfter(TimeSpan connected)
        {
            if (connected >= ProtocolLimits.BackoffReset) Reset();
        }

        void Reset() => _seconds = ClockTicks.Seconds(ProtocolLimits.BackoffFirst);
    }
}
