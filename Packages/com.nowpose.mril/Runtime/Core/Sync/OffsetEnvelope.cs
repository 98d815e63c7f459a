using System;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>Interval of the offsets that are consistent with the recent exchanges; valid for any network.</summary>
    /// <remarks>
    /// No packet arrives before it was sent, so each exchange proves t1 − t2 ≤ Φ ≤ t4 − t3, widened by half the resolution that the
    /// control clock stated in it. A server that follows another clock states its own error bound: the bounds of the true offset are
    /// wider by the maximum that it stated in that exchange or later. An older bound is extrapolated to the present with the estimated
    /// skew and widened by the error of the skew. The resulting interval is about as long as the minimum recent round-trip time.
    /// </remarks>
    sealed class OffsetEnvelope
    {
        /// <summary>Maximum number of exchanges, a minute at the usual pace: older bounds are wide, and a longer path must replace them.</summary>
        const int Window = 300;

        static readonly TimeSpan Oldest = TimeSpan.FromMinutes(1);

        readonly BoundsHistory _history = new BoundsHistory(Window, Oldest);
        readonly double _skewDoubt;

        /// <param name="skewDoubt">Error of an estimated skew beyond its standard errors, dimensionless: clock rates vary.</param>
        public OffsetEnvelope(double skewDoubt) => _skewDoubt = skewDoubt;

        public void Add(in SyncExchange exchange) => _history.Add(new OffsetBounds(exchange));

        public void Reset() => _history.Clear();

        /// <summary>Whether the exchange is consistent with the recent ones within a margin. It is not when a clock stepped.</summary>
        public bool Allows(in SyncExchange exchange, in ClockLine line, TimeSpan margin)
        {
            var proof = new OffsetBounds(exchange);
            var (least, greatest) = At(exchange.T4, line, includeServerError: false);
            return proof.Least - proof.HalfResolution <= greatest + margin.Ticks && proof.Greatest + proof.HalfResolution >= least - margin.Ticks;
        }

        /// <summary>
        /// Returns the maximum distance of the true offset from the line at its reference time, including the server's own error: the
        /// distance to the farther end of the interval.
        /// </summary>
        public TimeSpan GreatestError(in ClockLine line)
        {
            var (least, greatest) = At(line.Reference, line, includeServerError: true);
            var offset = line.Offset.HeadsetMinusControl.Ticks;
            return new TimeSpan(Math.Max(Math.Abs(greatest - offset), Math.Abs(offset - least)));
        }

        /// <summary>Returns the server's error bound for a line through the recent exchanges: their mean, but at least the newest.</summary>
        public TimeSpan ServerErrorBound()
        {
            if (_history.Count == 0) return default;
            var sum = 0.0;
            for (var i = 0; i < _history.Count; i++) sum += _history[i].ServerErrorBound;
            return new TimeSpan(Math.Max(_history[0].ServerErrorBound, (long)(sum / _history.Count)));
        }

        /// <summary>Adds the bounds relative to the line to a corridor, without the newest few.</summary>
        /// <param name="newest">Number of newest exchanges to omit; the result may be empty.</param>
        public void Fill(OffsetCorridor corridor, in ClockLine line, int newest)
        {
            corridor.Clear();
            for (var i = newest; i < _history.Count; i++) corridor.Add(line, _history[i]);
        }

        /// <param name="includeServerError">Whether the interval includes the error of the server's own clock.</param>
        (long Least, long Greatest) At(HeadsetTime now, in ClockLine line, bool includeServerError)
        {
            var doubt = line.Exchanges == 0 ? ClockLine.GreatestSkew : 3 * line.SkewError + _skewDoubt;
            // Half of the range of long, so that adding a margin to an end without a bound does not overflow.
            long least = long.MinValue / 2, greatest = long.MaxValue / 2, serverError = 0;
            for (var i = 0; i < _history.Count; i++)
            {
                ref readonly var proof = ref _history[i];
                // Starts with the newest: a server that states a larger error now may have had it since an earlier exchange.
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
