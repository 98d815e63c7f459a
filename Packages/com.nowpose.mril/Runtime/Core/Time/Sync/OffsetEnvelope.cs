using System;

namespace Nowpose.Sync
{
    /// <summary>The offsets that recent exchanges leave possible, whatever the network did.</summary>
    /// <remarks>
    /// No packet arrives before it was sent, so each exchange proves t1 − t2 ≤ Φ ≤ t4 − t3 (widened by half the resolution
    /// that the control clock said in it). A server that follows another clock may itself be wrong by what it said in the
    /// exchange; by so much more is the truth beside each proof, also after the server knows its clock better. An older proof is carried to the present by the estimated skew, and widened
    /// by what that may be wrong. All together leave an interval about as long as the least recent round trip.
    /// </remarks>
    sealed class OffsetEnvelope
    {
        /// <summary>A minute of the usual exchanges: older proofs are wide, and a path that has become longer is forgotten.</summary>
        const int Window = 300;

        static readonly TimeSpan Oldest = TimeSpan.FromMinutes(1);

        readonly BoundsHistory _history = new BoundsHistory(Window, Oldest);
        readonly double _skewDoubt;

        /// <param name="skewDoubt">What an estimated skew may be wrong beyond its standard errors, dimensionless: clocks do not run evenly.</param>
        public OffsetEnvelope(double skewDoubt) => _skewDoubt = skewDoubt;

        public void Add(in SyncExchange exchange) => _history.Add(new OffsetBounds(exchange));

        public void Reset() => _history.Clear();

        /// <summary>Whether the exchange and the recent ones can all be true, give or take a margin. They cannot when a clock stepped.</summary>
        public bool Allows(in SyncExchange exchange, in ClockLine line, TimeSpan margin)
        {
            var proof = new OffsetBounds(exchange);
            var (least, greatest) = At(exchange.T4, line, isTruth: false);
            return proof.Least - proof.HalfResolution <= greatest + margin.Ticks && proof.Greatest + proof.HalfResolution >= least - margin.Ticks;
        }

        /// <summary>
        /// How far the true offset can be from the line where it is anchored, the server's own error included: the distance to
        /// the farther end of the interval.
        /// </summary>
        public TimeSpan GreatestError(in ClockLine line)
        {
            var (least, greatest) = At(line.Reference, line, isTruth: true);
            var offset = line.Offset.HeadsetMinusControl.Ticks;
            return new TimeSpan(Math.Max(Math.Abs(greatest - offset), Math.Abs(offset - least)));
        }

        /// <summary>The most that a server said of its own clock's error in the recent exchanges: the line rests on all of them.</summary>
        public TimeSpan GreatestServerErrorBound()
        {
            long greatest = 0;
            for (var i = 0; i < _history.Count; i++) greatest = Math.Max(greatest, _history[i].ServerErrorBound);
            return new TimeSpan(greatest);
        }

        /// <summary>Where the bounds lie beside the line, without the newest few.</summary>
        /// <param name="newest">How many to leave out; none may be left then.</param>
        public void Fill(OffsetCorridor corridor, in ClockLine line, int newest)
        {
            corridor.Clear();
            for (var i = newest; i < _history.Count; i++) corridor.Add(line, _history[i]);
        }

        /// <param name="isTruth">Of the clock that the server follows, instead of what the server shows.</param>
        (long Least, long Greatest) At(HeadsetTime now, in ClockLine line, bool isTruth)
        {
            var doubt = line.Exchanges == 0 ? ClockLine.GreatestSkew : 3 * line.SkewError + _skewDoubt;
            // Halves, so that a margin can be added to the ends of an interval that nothing bounds yet.
            long least = long.MinValue / 2, greatest = long.MaxValue / 2;
            for (var i = 0; i < _history.Count; i++)
            {
                ref readonly var proof = ref _history[i];
                var beside = proof.HalfResolution + (isTruth ? proof.ServerErrorBound : 0);
                least = Math.Max(least, Carried(proof.Least, now - proof.Sent, line.Skew, -doubt) - beside);
                greatest = Math.Min(greatest, Carried(proof.Greatest, now - proof.Received, line.Skew, doubt) + beside);
            }
            return (least, greatest);
        }

        static long Carried(long bound, TimeSpan age, double skew, double widening) =>
            bound + (long)(age.Ticks * skew) + (long)(Math.Abs(age.Ticks) * widening);
    }
}
