using System;

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

        static bool IsFar(TimeSpan sinceEpoch) => sinceEpoch > MaxSinceEpoch || sinceEpoch < -MaxSinceEpoch;
    }
}
