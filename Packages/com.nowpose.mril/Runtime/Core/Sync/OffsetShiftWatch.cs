using System;
using System.Collections.Generic;
using Nowpose.Sync.Envelope;

namespace Nowpose.Sync
{
    /// <summary>Finds a step of a clock that is shorter than a round trip, which no exchange contradicts by itself.</summary>
    /// <remarks>
    /// When the offset steps, both bounds move with it: several requests arrive earlier than any ever could, and all replies
    /// later, or the other way round. A path that becomes shorter or longer moves one bound, or both apart: that is no step.
    /// A change of both paths at once, one shorter by as much as the other is longer, looks the same to anybody.
    /// </remarks>
    sealed class OffsetShiftWatch
    {
        /// <summary>Exchanges looked at, and how many of them must break a bound.</summary>
        const int Recent = 15, Violations = 3;

        /// <summary>
        /// Exchanges after which one makes the bounds itself, and how many older ones it takes to know them. Were it no more
        /// than those looked at, a step had to be plain the very moment that all of them are of after it.
        /// </summary>
        const int Guard = 2 * Recent, FewestPast = 30;

        /// <summary>Least step that counts, s, and in average latenesses divided by the number of older exchanges: how well bounds are known.</summary>
        const double LeastShift = 0.15e-3, LatenessShare = 10;

        /// <summary>How far the other bound must have moved at least, in what it seemed to move without a step: by chance all are late.</summary>
        const double OtherShare = 2;

        /// <summary>
        /// Share of the greater of both movements that the smaller one must be: a step moves both bounds alike. Paths that change move each
        /// by its own amount.
        /// </summary>
        const double CommonShare = 0.8;

        /// <summary>A line whose skew is known less well carries no bound through a minute.</summary>
        const double GreatestSkewError = 25e-6;

        readonly OffsetCorridor _past = new OffsetCorridor(Recent);
        readonly List<SyncExchange> _recent = new List<SyncExchange>(Recent);
        readonly double[] _below = new double[Recent];
        readonly double[] _above = new double[Recent];
        readonly double[] _sorted = new double[Recent];
        double _leastShift;
        int _first;

        /// <summary>By how much a recent exchange breaks a bound, be it for a step or for a path that has become shorter; zero if none does.</summary>
        public TimeSpan Suspicion { get; private set; }

        /// <summary>The exchanges since the step that <see cref="Judge"/> has found; a copy.</summary>
        public SyncExchange[] Since => _recent.GetRange(_first, _recent.Count - _first).ToArray();

        public void Reset()
        {
            _recent.Clear();
            Suspicion = TimeSpan.Zero;
        }

        /// <returns>Whether a clock has stepped.</returns>
        /// <param name="exchange">Not yet in the envelope.</param>
        /// <param name="line">Without the exchange.</param>
        public bool Judge(in SyncExchange exchange, in ClockLine line, OffsetEnvelope envelope)
        {
            if (_recent.Count == Recent) _recent.RemoveAt(0);
            _recent.Add(exchange);
            Suspicion = TimeSpan.Zero;
            if (line.Exchanges == 0 || line.SkewError > GreatestSkewError) return false;
            envelope.Fill(_past, line, Guard - 1);
            if (_past.Count < FewestPast) return false;

            // Positive where the bound is broken: the offset rose, or fell.
            for (var i = 0; i < _recent.Count; i++)
            {
                var (below, above) = OffsetCorridor.Beside(line, new OffsetBounds(_recent[i]));
                _below[i] = below - _past.Least;
                _above[i] = _past.Greatest - above;
            }
            // A clock that advances in steps of its resolution seems to make one now and then.
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
            if (otherMoved <= Math.Max(byChance, CommonShare * greatest) || CommonShare * otherMoved > greatest + byChance) return false;
            _first = Array.FindIndex(broken, value => value > margin);
            return true;
        }
    }
}
