using System;
using System.Collections.Generic;

namespace Nowpose.Sync
{
    /// <summary>The offsets that recent exchanges leave possible, whatever the network did.</summary>
    /// <remarks>
    /// No packet arrives before it was sent, so each exchange proves t1 − t2 ≤ Φ ≤ t4 − t3. An older proof is carried to
    /// the present by widening it by the greatest credible skew. All together leave an interval about as long as the
    /// least recent round trip.
    /// </remarks>
    sealed class OffsetEnvelope
    {
        const int Window = 25;

        /// <summary>No oscillator of a headset or a PLC is off by more; at 25 exchanges of 200 ms it widens a proof by half a millisecond.</summary>
        const double GreatestSkew = 100e-6;

        readonly Queue<Proof> _proofs = new Queue<Proof>();

        public void Add(in SyncExchange exchange)
        {
            _proofs.Enqueue(new Proof(exchange));
            if (_proofs.Count > Window) _proofs.Dequeue();
        }

        public void Reset() => _proofs.Clear();

        /// <summary>Whether the exchange and the recent ones can all be true, give or take a margin. They cannot when a clock stepped.</summary>
        public bool Allows(in SyncExchange exchange, TimeSpan margin)
        {
            var proof = new Proof(exchange);
            var (least, greatest) = At(proof.At);
            return proof.Least <= greatest + margin.Ticks && proof.Greatest >= least - margin.Ticks;
        }

        /// <summary>How far the true offset can be from an estimate: the distance to the farther end of the interval.</summary>
        public TimeSpan GreatestError(HeadsetTime at, ClockOffset estimate)
        {
            var (least, greatest) = At(at);
            var offset = estimate.HeadsetMinusControl.Ticks;
            return new TimeSpan(Math.Max(Math.Abs(greatest - offset), Math.Abs(offset - least)));
        }

        (long Least, long Greatest) At(HeadsetTime now)
        {
            // Halves, so that a margin can be added to the ends of an interval that nothing bounds yet.
            long least = long.MinValue / 2, greatest = long.MaxValue / 2;
            foreach (var proof in _proofs)
            {
                var widening = (long)((now - proof.At).Ticks * GreatestSkew);
                least = Math.Max(least, proof.Least - widening);
                greatest = Math.Min(greatest, proof.Greatest + widening);
            }
            return (least, greatest);
        }

        /// <summary>Ticks of 100 ns.</summary>
        readonly struct Proof
        {
            public Proof(in SyncExchange exchange)
            {
                var half = exchange.Resolution.Ticks / 2;
                At = exchange.T4;
                Least = (exchange.T1.SinceEpoch - exchange.T2.SinceEpoch).Ticks - half;
                Greatest = (exchange.T4.SinceEpoch - exchange.T3.SinceEpoch).Ticks + half;
            }

            public HeadsetTime At { get; }
            public long Least { get; }
            public long Greatest { get; }
        }
    }
}
