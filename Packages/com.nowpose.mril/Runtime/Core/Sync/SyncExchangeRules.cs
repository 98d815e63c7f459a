using System;
using Nowpose.Protocol;

namespace Nowpose.Sync
{
    /// <summary>Validates an exchange before it reaches an estimator.</summary>
    static class SyncExchangeRules
    {
        /// <summary>Maximum distance from the epoch: half the range of 64-bit nanoseconds.</summary>
        static readonly TimeSpan MaxSinceEpoch = new TimeSpan(long.MaxValue / 2 / ClockTicks.NanosecondsPerTick);

        public static SyncExchangeFault Check(in SyncExchange exchange)
        {
            if (IsFar(exchange.T1.SinceEpoch) || IsFar(exchange.T2.SinceEpoch) || IsFar(exchange.T3.SinceEpoch) || IsFar(exchange.T4.SinceEpoch))
                return SyncExchangeFault.ImplausibleTime;
            if (exchange.T3 < exchange.T2) return SyncExchangeFault.ControlTimeReversed;
            if (exchange.T4 < exchange.T1) return SyncExchangeFault.HeadsetTimeReversed;
            if (exchange.RoundTripTime < -exchange.Resolution) return SyncExchangeFault.NegativeRoundTrip;
            return SyncExchangeFault.None;
        }

        /// <param name="reply">The reply of the exchange, whose nanoseconds are finer than the ticks of the exchange.</param>
        public static SyncExchangeFault CheckReply(in SyncExchange exchange, in SyncFrame reply)
        {
            var fault = Check(exchange);
            if (fault != SyncExchangeFault.None) return fault;
            if (reply.T3Ns < reply.T2Ns) return SyncExchangeFault.ControlTimeReversed;
            var elapsedNs = (exchange.T4 - exchange.T1).Ticks * ClockTicks.NanosecondsPerTick;
            return reply.T3Ns - reply.T2Ns > elapsedNs + reply.ResolutionNs ? SyncExchangeFault.NegativeRoundTrip : SyncExchangeFault.None;
        }

        static bool IsFar(TimeSpan sinceEpoch) => sinceEpoch > MaxSinceEpoch || sinceEpoch < -MaxSinceEpoch;
    }
}
