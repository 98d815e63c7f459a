using System;
using System.Collections.Generic;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>Detects a clock step that is shorter than a round-trip time, which no single exchange contradicts.</summary>
    /// <remarks>
    /// When the offset steps, both bounds move with it: several requests arrive earlier than before, and all replies later, or the
    /// other way round. A path that becomes shorter or longer moves one bound, or both apart, which is not a step.
    /// If one path becomes shorter by as much as the other becomes longer, the change is not distinguishable from a step.
    /// </remarks>
    sealed class OffsetShiftWatch
    {
        /// <summary>Number of recent exchanges, and how many of them must break a bound.</summary>
        const int Recent = 15, Violations = 3;

        /// <summary>
        /// Age in exchanges after which an exchange contributes to the bounds, and minimum number of older exchanges. If the guard were
        /// only as long as the recent exchanges, a step could be detected only at the moment when all of them are after it.
        /// </summary>
        const int Guard = 2 * Recent, FewestPast = 30;

        /// <summary>Minimum step, s; and in mean latenesses divided by the number of older exchanges, which is the accuracy of the bounds.</summary>
        const double LeastShift = 0.15e-3, LatenessShare = 10;

        /// <summary>Minimum movement of the other bound, relative to its apparent movement without a step: all packets may be late.</summary>
        const double OtherShare = 2;

        /// <summary>
        /// Minimum ratio of the smaller movement to the larger one: a step moves both bounds by the same amount, while paths change by
        /// different amounts.
        /// </summary>
        const double CommonShare = 0.8;

        /// <summary>Maximum standard error of the skew with which a bound can be extrapolated over a minute.</summary>
        const double GreatestSkewError = 25e-6;

        readonly OffsetCorridor _past = new OffsetCorridor(Recent);
        readonly List<SyncExchange> _recent = new List<SyncExchange>(Recent);
        readonly double[] _below = new double[Recent];
        readonly double[] _above = new double[Recent];
        readonly double[] _sorted = new double[Recent];
        double _leastShift;
        int _first;

        /// <summary>Maximum violation of a bound by recent exchanges, caused by a step or by a path that has become shorter; zero for none.</summary>
        public TimeSpan Suspicion { get; private set; }

        /// <summary>Copy of the exchanges since the step that <see cref="Judge"/> detected.</summary>
        public SyncExchange[] Since => _recent.GetRange(_first, _recent.Count - _first).ToArray();

        public void Reset()
        {
            _recent.Clear();
            Suspicion = TimeSpan.Zero;
        }

        /// <returns>Whether a clock has stepped.</returns>
        /// <param name="exchange">An exchange that is not yet in the envelope.</param>
        /// <param name="line">The line without the exchange.</param>
        public bool Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope)
        {
            if (_recent.Count == Recent) _recent.RemoveAt(0);
            _recent.Add(exchange);
            Suspicion = TimeSpan.Zero;
            if (line.Exchanges == 0 || line.SkewError > GreatestSkewError) return false;
            envelope.Fill(_past, line, Guard - 1);
            if (_past.Count < FewestPast) return false;

            // Positive when the bound is broken: the offset rose for the lower bound, or fell for the upper one.
            for (var i = 0; i < _recent.Count; i++)
            {
                var (below, above) = OffsetCorridor.Beside(line, new OffsetBounds(_recent[i]));
                _below[i] = below - _past.Least;
                _above[i] = _past.Greatest - above;
            }
            // A clock with a coarse resolution appears to step by its resolution occasionally.
            _leastShift = LeastShift + ClockTicks.Seconds(exchange.Resolution);
            return HasShifted(_below, _above, _past.RowAbove) || HasShifted(_above, _below, _past.RowBelow);
        }

        bool HasShifted(double[] broken, double[] other, double otherByChance)
        {
            var margin = Math.Max(_leastShift, LatenessShare * _past.Lateness / _past.Count);
            var count = _recent.Count;
            Array.Copy(broken, _sorted, count);
            Array.Sort(_sorted, 0, count);
            var greatest = _sorted[count - 1];
            if (greatest <= margin) return false;
            if (ClockTicks.Span(greatest) > Suspicion) Suspicion = ClockTicks.Span(greatest);
            if (count < Recent || _sorted[Recent - Violations] <= margin) return false;

            var byChance = Math.Max(margin, OtherShare * otherByChance);
            var otherMoved = -other[0];
            for (var i = 1; i < count; i++) otherMoved = Math.Min(otherMoved, -other[i]);
            if (otherMoved <= Math.Max(byChance, CommonShare * greatest)) return false;
            if (CommonShare * otherMoved > greatest + Math.Max(margin, otherByChance)) return false;
            _first = Array.FindIndex(broken, value => value > margin);
            return true;
        }
    }
}
