using System;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>The offsets that recent exchanges leave possible, whatever the network did.</summary>
    /// <remarks>
    /// No packet arrives before it was sent, so each exchange proves t1 − t2 ≤ Φ ≤ t4 − t3 (widened by half the resolution
    /// that the control clock said in it). A server that follows another clock says how wrong its own may be: bounds of the
    /// true offset are wider by the most that it has said in that exchange or since. An older proof is carried to the present by
    /// the estimated skew, and widened by what that may be wrong. All together leave an interval about as long as the least recent round trip.
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
            var (least, greatest) = At(exchange.T4, line, includeServerError: false);
            return proof.Least - proof.HalfResolution <= greatest + margin.Ticks && proof.Greatest + proof.HalfResolution >= least - margin.Ticks;
        }

        /// <summary>
        /// How far the true offset can be from the line where it is anchored, the server's own error included: the distance to
        /// the farther end of the interval.
        /// </summary>
        public TimeSpan GreatestError(in ClockLine line)
        {
            var (least, greatest) = At(line.Reference, line, includeServerError: true);
            var offset = line.Offset.HeadsetMinusControl.Ticks;
            return new TimeSpan(Math.Max(Math.Abs(greatest - offset), Math.Abs(offset - least)));
        }

        /// <summary>The server's error bound that counts for a line through the recent exchanges: their mean, but at least the newest.</summary>
        public TimeSpan ServerErrorBound()
        {
            if (_history.Count == 0) return default;
            var sum = 0.0;
            for (var i = 0; i < _history.Count; i++) sum += _history[i].ServerErrorBound;
            return new TimeSpan(Math.Max(_history[0].ServerErrorBound, (long)(sum / _history.Count)));
        }

        /// <summary>Where the bounds lie beside the line, without the newest few.</summary>
        /// <param name="newest">How many to leave out; none may be left then.</param>
        public void Fill(OffsetCorridor corridor, in ClockLine line, int newest)
        {
            corridor.Clear();
            for (var i = newest; i < _history.Count; i++) corridor.Add(line, _history[i]);
        }

        /// <param name="includeServerError">Whether the interval includes the error of the server's own clock.</param>
        (long Least, long Greatest) At(HeadsetTime now, in ClockLine line, bool includeServerError)
        {
            var doubt = line.Exchanges == 0 ? ClockLine.GreatestSkew : 3 * line.SkewError + _skewDoubt;
            // Halves, so that a margin can be added to the ends of an interval that nothing bounds yet.
            long least = long.MinValue / 2, greatest = long.MaxValue / 2, serverError = 0;
            for (var i = 0; i < _history.Count; i++)
            {
                ref readonly var proof = ref _history[i];
                // The newest first: a server that knows its clock less well than it said before may have been wrong since.
                if (includeServerError) serverError = Math.Max(serverError, proof.ServerErrorBound);
                var margin = proof.HalfResolution + serverError;
                least = Math.Max(least, Carried(proof.Least, now - proof.Sent, line.Skew, -doubt) - margin);
                greatest = Math.Min(greatest, Carried(proof.Greatest, now - proof.Received, line.Skew, doubt) + margin);
            }
            return (least, greatest);
        }

        static long Carried(long bound, TimeSpan age, double skew, double widening) =>
            bound + (long)(age.Ticks * skew) + (long)(Math.Abs(age.Ticks) * widening);
    }
}
