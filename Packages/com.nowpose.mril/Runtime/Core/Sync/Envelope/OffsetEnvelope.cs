using System;
using System.Runtime.CompilerServices;

namespace Nowpose.Sync.Envelope
{
    /// <summary>Interval of the offsets that are consistent with the recent exchanges; valid for any network.</summary>
    /// <remarks>
    /// No packet arrives before it was sent, so each exchange proves t1 − t2 ≤ Φ ≤ t4 − t3, widened by half the resolution that the control
    /// clock stated in that exchange. A server that follows another clock states its own error bound. The bounds of the true offset are
    /// therefore wider by the maximum error bound stated in that exchange or later. An older bound is extrapolated to the present with the
    /// estimated skew and widened by the error of the skew. The resulting interval is about as long as the minimum recent round-trip time.
    /// </remarks>
    sealed class OffsetEnvelope
    {
        /// <summary>
        /// Maximum number of exchanges: a minute at the usual pace. Older bounds are wide, and after a change of the path, the earlier bounds must
        /// expire.
        /// </summary>
        const int Window = 300;

        static readonly TimeSpan Oldest = TimeSpan.FromMinutes(1);

        readonly BoundsHistory _history = new BoundsHistory(Window, Oldest);
        readonly double _skewUncertainty;

        /// <param name="skewUncertainty">
        /// Error of an estimated skew in addition to its standard errors, dimensionless, because clock rates vary.
        /// </param>
        public OffsetEnvelope(double skewUncertainty) => _skewUncertainty = skewUncertainty;

        public void Add(in SyncExchange exchange) => _history.Add(new OffsetBounds(exchange));

        public void Reset() => _history.Clear();

        /// <summary>Returns whether an exchange is consistent with recent exchanges within a margin; false after a clock step.</summary>
        /// <param name="includeServerError">
        /// Whether the bounds of each exchange are widened by the error bound that the server stated in it. The result is then also true after a
        /// correction of the server's clock within these bounds.
        /// </param>
        public bool Allows(in SyncExchange exchange, in ClockLine line, TimeSpan margin, bool includeServerError = false)
        {
            var bounds = new OffsetBounds(exchange);
            var (lower, upper) = At(exchange.T4, line, includeServerError ? ServerError.AsStated : ServerError.Ignored);
            var allowed = bounds.HalfResolution + margin.Ticks + (includeServerError ? bounds.ServerErrorBound : 0);
            return bounds.Lower - allowed <= upper && bounds.Upper + allowed >= lower;
        }

        /// <summary>
        /// Returns whether a correction of the server within the error bounds that it stated explains an exchange. Such a correction moves each
        /// bound by at most the sum of the error bounds, while a clock step that the round-trip time hides moves it further.
        /// </summary>
        public bool Explains(in SyncExchange exchange, in ClockLine line, TimeSpan margin)
        {
            if (!Allows(exchange, line, margin, includeServerError: true)) return false;
            var bounds = new OffsetBounds(exchange);
            var (lower, upper) = At(exchange.T4, line, ServerError.Ignored);
            var allowed = bounds.HalfResolution + margin.Ticks + bounds.ServerErrorBound + MaxServerErrorBound().Ticks;
            return bounds.Lower - lower <= allowed && upper - bounds.Upper <= allowed;
        }

        /// <summary>
        /// Returns the minimum and the maximum distance of the true offset from the line at its reference time, including the server's own error: the
        /// distances to the nearer end of the interval (zero for a line in the interval) and to the farther end.
        /// </summary>
        public (TimeSpan Min, TimeSpan Max) ErrorOf(in ClockLine line)
        {
            var (lower, upper) = At(line.Reference, line, ServerError.AsStatedSince);
            var offset = line.Offset.HeadsetMinusControl.Ticks;
            return (new TimeSpan(Math.Max(0, Math.Max(lower - offset, offset - upper))),
                new TimeSpan(Math.Max(Math.Abs(upper - offset), Math.Abs(offset - lower))));
        }

        /// <summary>
        /// Returns the server's error bound for a line through the recent exchanges: the larger of the mean bound and the newest bound.
        /// </summary>
        public TimeSpan ServerErrorBound()
        {
            if (_history.Count == 0) return default;
            var sum = 0.0;
            for (var i = 0; i < _history.Count; i++) sum += _history[i].ServerErrorBound;
            return new TimeSpan(Math.Max(_history[0].ServerErrorBound, (long)(sum / _history.Count)));
        }

        /// <summary>Returns the maximum error bound that the server stated in the recent exchanges.</summary>
        public TimeSpan MaxServerErrorBound()
        {
            long max = 0;
            for (var i = 0; i < _history.Count; i++) max = Math.Max(max, _history[i].ServerErrorBound);
            return new TimeSpan(max);
        }

        /// <summary>Replaces the contents of a corridor with the bounds relative to the line, without the bounds of the newest exchanges.</summary>
        /// <param name="newest">Number of newest exchanges to omit; the result may be empty.</param>
        public void Fill(OffsetCorridor corridor, in ClockLine line, int newest)
        {
            corridor.Clear();
            for (var i = newest; i < _history.Count; i++) corridor.Add(line, _history[i]);
        }

        (long Lower, long Upper) At(HeadsetTime now, in ClockLine line, ServerError included)
        {
            var skewError = line.Exchanges == 0 ? ClockLine.MaxSkew : 3 * line.SkewError + _skewUncertainty;
            // Uses half of the range of long, so that adding a margin to an end without a bound does not overflow.
            long lower = long.MinValue / 2, upper = long.MaxValue / 2, maxServerError = 0;
            for (var i = 0; i < _history.Count; i++)
            {
                ref readonly var bounds = ref _history[i];
                // The newest exchange is the first in the history, so this is the maximum over this exchange and all later exchanges.
                maxServerError = Math.Max(maxServerError, bounds.ServerErrorBound);
                var serverError = included switch
                {
                    ServerError.AsStated => bounds.ServerErrorBound,
                    ServerError.AsStatedSince => maxServerError,
                    _ => 0,
                };
                var margin = bounds.HalfResolution + serverError;
                lower = Math.Max(lower, Extrapolated(bounds.Lower, (now - bounds.Sent).Ticks, line.Skew, -skewError) - margin);
                upper = Math.Min(upper, Extrapolated(bounds.Upper, (now - bounds.Received).Ticks, line.Skew, skewError) + margin);
            }
            return (lower, upper);
        }

        /// <summary>Selects the error of the server's own clock by which the bounds are widened.</summary>
        enum ServerError
        {
            Ignored,

            /// <summary>The error bound in the same exchange.</summary>
            AsStated,

            /// <summary>
            /// The maximum error bound in the same exchange or later. If the server states a larger error bound later, its error may already have
            /// been as large at the time of the exchange.
            /// </summary>
            AsStatedSince,
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static long Extrapolated(long bound, double ageTicks, double skew, double widening) =>
            bound + (long)(ageTicks * skew) + (long)(Math.Abs(ageTicks) * widening);
    }
}
