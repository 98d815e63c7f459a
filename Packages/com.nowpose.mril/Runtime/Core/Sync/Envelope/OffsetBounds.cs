namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Bounds of the offset from one exchange, in ticks of 100 ns. They are valid for any network, because no packet arrives before it
    /// was sent: <see cref="Lower"/> = t1 − t2 ≤ Φ(t1), and <see cref="Upper"/> = t4 − t3 ≥ Φ(t4).
    /// </summary>
    readonly struct OffsetBounds
    {
        public OffsetBounds(in SyncExchange exchange)
        {
            Sent = exchange.T1;
            Lower = (exchange.T1.SinceEpoch - exchange.T2.SinceEpoch).Ticks;
            Received = exchange.T4;
            Upper = (exchange.T4.SinceEpoch - exchange.T3.SinceEpoch).Ticks;
            HalfResolution = exchange.Resolution.Ticks / 2;
            ServerErrorBound = exchange.ServerErrorBound.Ticks;
        }

        OffsetBounds(in OffsetBounds of, long lower, long upper)
        {
            this = of;
            Lower = lower;
            Upper = upper;
        }

        /// <summary>t1, the time of <see cref="Lower"/>.</summary>
        public HeadsetTime Sent { get; }

        public long Lower { get; }

        /// <summary>t4, the time of <see cref="Upper"/>.</summary>
        public HeadsetTime Received { get; }

        public long Upper { get; }

        /// <summary>Half the stated resolution of the control clock in ticks, the maximum error of each bound.</summary>
        public long HalfResolution { get; }

        /// <summary>Error bound that the server states for its own clock, ticks.</summary>
        public long ServerErrorBound { get; }

        /// <summary>Returns the same exchange with both bounds moved; the amounts are in ticks.</summary>
        public OffsetBounds Shifted(long lower, long upper) => new OffsetBounds(this, Lower + lower, Upper + upper);
    }
}
