namespace Nowpose.Sync
{
    /// <summary>What an exchange must satisfy before an estimator may see it.</summary>
    public static class SyncExchangeRules
    {
        public static SyncExchangeFault Check(in SyncExchange exchange)
        {
            if (exchange.T3 < exchange.T2) return SyncExchangeFault.ControlTimeReversed;
            if (exchange.T4 < exchange.T1) return SyncExchangeFault.HeadsetTimeReversed;
            if (exchange.RoundTripTime < -exchange.Resolution) return SyncExchangeFault.NegativeRoundTrip;
            return SyncExchangeFault.None;
        }
    }
}
