using System;
using System.Collections.Generic;

namespace Nowpose.Sync
{
    /// <summary>The offsets that recent exchanges leave possible, whatever the network did.</summary>
    /// <remarks>
    /// No packet arrives before it was sent, so each exchange proves t1 − t2 ≤ Φ ≤ t4 − t3 (widened by half the control
    /// clock's resolution, where it is known). An older proof is carried to the present by the estimated skew, and widened
    /// by what that may be wrong. All together leave an interval about as long as the least recent round trip.
    /// </remarks>
    sealed class OffsetEnvelope
    {
        const int Window = 25;

        /// <summary>
        /// What an estimated skew may be wrong beyond its standard errors, which know nothing of delays that come in bursts:
        /// half a millisecond over the usual window. With less, busy networks were taken for clock steps.
        /// </summary>
        const double SkewDoubt = 100e-6;

        readonly Queue<Proof> _proofs = new Queue<Proof>();

        public void Add(in SyncExchange exchange)
        {
            _proofs.Enqueue(new Proof(exchange));
            if (_proofs.Count > Window) _proofs.Dequeue();
        }

        public void Reset() => _proofs.Clear();

        /// <summary>Whether the exchange and the recent ones can all be true, give or take a margin. They cannot when a clock stepped.</summary>
        public bool Allows(in SyncExchange exchange, in ClockLine line, TimeSpan margin)
        {
            var proof = new Proof(exchange);
            var (least, greatest) = At(proof.At, line);
            return proof.Least <= greatest + margin.Ticks && proof.Greatest >= least - margin.Ticks;
        }

        /// <summary>How far the true offset can be from the line where it is anchored: the distance to the farther end of the interval.</summary>
        public TimeSpan GreatestError(in ClockLine line)
        {
            var (least, greatest) = At(line.Reference, line);
            var offset = line.Offset.HeadsetMinusControl.Ticks;
            return new TimeSpan(Math.Max(Math.Abs(greatest - offset), Math.Abs(offset - least)));
        }

        (long Least, long Greatest) At(HeadsetTime now, in ClockLine line)
        {
            // A young line's slope may follow a burst of late replies: until it is older than the window, none is believed.
            var isMature = line.Exchanges >= 2 * Window;
            var skew = isMature ? line.Skew : 0;
            var doubt = isMature ? 3 * line.SkewError + SkewDoubt : ClockLine.GreatestSkew;
            // Halves, so that a margin can be added to the ends of an interval that nothing bounds yet.
            long least = long.MinValue / 2, greatest = long.MaxValue / 2;
            foreach (var proof in _proofs)
            {
                var age = (now - proof.At).Ticks;
                var carried = (long)(age * skew);
                var widening = (long)(Math.Abs(age) * doubt);
                least = Math.Max(least, proof.Least + carried - widening);
                greatest = Math.Min(greatest, proof.Greatest + carried + widening);
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
