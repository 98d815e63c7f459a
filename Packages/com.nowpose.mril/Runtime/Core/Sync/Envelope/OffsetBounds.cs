namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// What one exchange proves, whatever the network did, in ticks of 100 ns: no packet arrives before it was sent, so
    /// <see cref="Least"/> = t1 − t2 ≤ Φ(t1), and <see cref="Greatest"/> = t4 − t3 ≥ Φ(t4).
    /// </summary>
    readonly struct OffsetBounds
    {
        public OffsetBounds(in SyncExchange exchange)
        {
            Sent = exchange.T1;
            Least = (exchange.T1.SinceEpoch - exchange.T2.SinceEpoch).Ticks;
            Received = exchange.T4;
            Greatest = (exchange.T4.SinceEpoch - exchange.T3.SinceEpoch).Ticks;
            HalfResolution = exchange.Resolution.Ticks / 2;
            ServerErrorBound = exchange.ServerErrorBound.Ticks;
        }

        OffsetBounds(in OffsetBounds of, long least, long greatest)
        {
            this = of;
            Least = least;
            Greatest = greatest;
        }

        /// <summary>t1, when <see cref="Least"/> held.</summary>
        public HeadsetTime Sent { get; }

        public long Least { get; }

        /// <summary>t4, when <see cref="Greatest"/> held.</summary>
        public HeadsetTime Received { get; }

        public long Greatest { get; }

        /// <summary>Half the resolution that the control clock said: by so much each bound may be wrong.</summary>
        public long HalfResolution { get; }

        /// <summary>The server's stated bound of its own clock's error, ticks.</summary>
        public long ServerErrorBound { get; }

        /// <summary>The same exchange with its bounds moved, ticks.</summary>
        public OffsetBounds Shifted(long least, long greatest) => new OffsetBounds(this, Least + least, Greatest + greatest);
    }
}
