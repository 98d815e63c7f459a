using System;

namespace Nowpose.Sync.Envelope
{
    /// <summary>
    /// Detects a change of the minimum delay in one direction, for example when a headset roams to another access point, and keeps
    /// the bounds of that direction comparable across the change.
    /// </summary>
    /// <remarks>
    /// A longer minimum delay makes all bounds of its direction late. Uncorrected, these bounds would move the offset by half the change and, while
    /// they replace the older bounds, would look like a change of the skew. The clock rates do not change, so the excess over the earlier minimum
    /// delay is added to each bound, and the offset and the skew are unchanged. A delay that is shorter than all earlier delays replaces the
    /// reference, and the offset moves by half the difference. In both cases the error is half the difference of the changes of the two directions.
    /// Until a change is recognised, the fit may follow it by 1.2 times this amount. If a change is too small to be distinguished from a wrong skew,
    /// the offset moves by half of the change. The error is then increased if the other direction shows that the path has changed. Allocates nothing
    /// after construction.
    /// </remarks>
    sealed class MinDelay
    {
        /// <summary>Minimum change, s. The fit absorbs smaller changes, with a negligible error of half the change.</summary>
        const double MinChange = 0.2e-3;

        /// <summary>
        /// Maximum number of exchanges before the change from which the earlier minimum delay is determined: 40 s at five exchanges per second.
        /// </summary>
        const int MaxEarlier = 200;

        const int MinEarlier = 60;

        /// <summary>
        /// MinDuration: minimum duration of a window. MinDurationScattered: minimum duration of a window whose delays scatter more than before. A
        /// queue in a busy network also makes all packets late, but by unequal amounts and for less than MinDurationScattered.
        /// </summary>
        static readonly TimeSpan MinDuration = TimeSpan.FromSeconds(6), MinDurationScattered = TimeSpan.FromSeconds(30);

        /// <summary>
        /// Minimum duration of a window after the delay in the other direction has changed. It has an effect only while exchanges are frequent.
        /// </summary>
        static readonly TimeSpan MinDurationExpected = TimeSpan.FromSeconds(3);

        /// <summary>
        /// Maximum relative increase of the median lateness of a window over the median lateness of the earlier exchanges, times the square root of
        /// the window's length. A larger increase means that the delays scatter more. The value corresponds to about two standard errors of the
        /// median of exponential delays.
        /// </summary>
        const double MaxScatterGrowth = 3;

        /// <summary>
        /// Lengths, in exchanges, of the windows in which every bound must be late; extended to the minimum duration. A direction with
        /// little scatter shows a change in the first window; a noisy direction needs the last window.
        /// </summary>
        static readonly int[] Windows = { 30, 60, 105, 150, 210, 300, MaxWindow };

        /// <summary>Maximum length of a window in exchanges: 90 s at five per second.</summary>
        const int MaxWindow = 450;

        /// <summary>Maximum number of measured bounds.</summary>
        public const int MaxCount = MaxWindow + MaxEarlier;

        /// <summary>
        /// Divisor that gives the length of a window's oldest part. This part is not used to determine the size of a change, because it may precede
        /// the change.
        /// </summary>
        const int BoundaryShare = 6;

        /// <summary>Negative logarithm of the probability that all bounds of a window are late by chance, for independent delays.</summary>
        const double Significance = 20;

        /// <summary>
        /// Required significance after the delay in the other direction has changed. The delay in this direction has then probably changed too.
        /// </summary>
        const double ExpectedSignificance = 7;

        /// <summary>Significance of a change that may be hidden by a wrong skew. Such a change only increases the error.</summary>
        const double HiddenSignificance = 3;

        /// <summary>
        /// ShorterWindow: number of exchanges that are searched for a shorter delay. ShorterCount: minimum number of exchanges that show it.
        /// StepWindow: number of exchanges within which a clock step is detected, see <see cref="OffsetShiftWatch"/>.
        /// </summary>
        const int ShorterWindow = 32, ShorterCount = 3, StepWindow = 16;

        /// <summary>Minimum decrease of a delay, in units of the median lateness divided by the number of earlier exchanges.</summary>
        const double LatenessShare = 15;

        /// <summary>
        /// Shift of the bounds that is attributed to a wrong skew, in standard errors of the skew, for a longer and for a shorter delay. The value
        /// for a longer delay is smaller, because the round-trip times also show a longer delay.
        /// </summary>
        const double SkewErrorsLonger = 1, SkewErrorsShorter = 1.5;

        readonly int _sign;
        readonly BoundsHistory _history;
        readonly double[] _tightness = new double[MaxCount];
        readonly double[] _shorter = new double[ShorterWindow];
        readonly double[] _lateness = new double[MaxCount];
        double _excess, _excessError, _referenceError, _hiddenError;
        int _count, _sinceChange, _sinceHidden, _sinceShorter, _looks;

        /// <param name="sign">1 for the bounds below the offset, from requests; −1 for the bounds above it, from replies.</param>
        public MinDelay(int sign, BoundsHistory history)
        {
            _sign = sign;
            _history = history;
        }

        /// <summary>Current minimum delay minus the smallest known minimum delay, s; zero or more.</summary>
        public double Excess => _excess;

        /// <summary>Uncertainty of the corrections, s.</summary>
        public double Error => _excessError + _referenceError + _hiddenError;

        /// <summary>Number of measured bounds.</summary>
        public int Count => _count;

        /// <summary>Returns the largest tightness of the measured bounds in a range. Only differences between values are meaningful.</summary>
        /// <param name="from">Age of the newest bound of the range.</param>
        /// <param name="to">Age of the oldest bound of the range plus 1 (exclusive).</param>
        public double Tightest(int from, int to)
        {
            var max = double.NegativeInfinity;
            // A comparison takes a fraction of the time of Math.Max; the processor predicts the branch.
            for (var i = from; i < to; i++)
                if (_tightness[i] > max) max = _tightness[i];
            return max;
        }

        public void Reset()
        {
            _count = 0;
            _excess = _excessError = _referenceError = _hiddenError = 0;
            _sinceChange = _sinceShorter = _looks = 0;
        }

        /// <summary>Measures the bounds of the history relative to a curve. The newest bound is already corrected by <see cref="Excess"/>.</summary>
        /// <param name="curve">Shape of the offset; its height has no effect.</param>
        public void Measure(OffsetCurve curve)
        {
            _count = Math.Min(_history.Count, _tightness.Length);
            if (_count == 0) return;
            var (newestAt, newest) = BoundOf(_history[0]);
            for (var i = 0; i < _count; i++)
            {
                var (at, bound) = BoundOf(_history[i]);
                _tightness[i] = _sign * (ClockTicks.Seconds(new TimeSpan(bound - newest)) - curve.At(ClockTicks.Seconds(at - newestAt)));
            }
        }

        /// <summary>Searches the measured bounds for a change.</summary>
        /// <param name="other">The other direction, measured relative to the same curve.</param>
        /// <param name="skewError">Standard error of the curve's slope.</param>
        /// <param name="resolution">Resolution of the control clock, s. Bounds move by this amount even if the path does not change.</param>
        /// <returns>Number of exchanges since the detected change; 0 if no change was detected.</returns>
        public int Update(MinDelay other, double skewError, double resolution)
        {
            _sinceChange++;
            _sinceHidden++;
            if (_count < MinEarlier + ShorterWindow) return 0;
            if (_excess > 0) ReduceExcess(_count);
            if (_sinceShorter > 0) RefineReference(_count);
            if (FindLonger(other, _count, skewError, resolution)) return _sinceChange;
            return FindShorter(_count, skewError, resolution) ? _sinceShorter : 0;
        }

        // Returns the lateness of a window's tightest bound relative to the tightest earlier bound; negative if it is tighter.
        double Lateness(int window, int earlier) => Tightest(window, earlier) - Tightest(0, window);

        (HeadsetTime At, long Bound) BoundOf(in OffsetBounds bounds) =>
            _sign > 0 ? (bounds.Sent, bounds.Lower) : (bounds.Received, bounds.Upper);

        // Reduces the excess if the newest bound, corrected by it, is tighter than all earlier bounds: the excess was then too large.
        void ReduceExcess(int count)
        {
            var violation = Math.Min(_excess, _tightness[0] - Tightest(1, count));
            if (violation <= 0) return;
            // A remaining excess below half the minimum change is caused by individual late exchanges, not by a path change, so it is removed.
            if (_excess - violation < MinChange / 2) violation = _excess;
            // A small violation means that the excess was overestimated; a large violation means that the path has changed again at this exchange.
            var isEstimate = violation < 3 * _excessError;
            Shift(0, isEstimate ? Math.Min(_sinceChange, count) : 1, -violation);
            _excessError *= 1 - violation / _excess;
            _excess -= violation;
            if (!isEstimate) _sinceChange = 1;
        }

        bool FindLonger(MinDelay other, int count, double skewError, double resolution)
        {
            // After a change of the path in one direction, a change in the other direction is also likely, but by a different amount.
            var isExpected = (other._excess > 0 && other._sinceChange <= MaxWindow) || other._sinceShorter > 0;
            var minDuration = isExpected ? MinDurationExpected : MinDuration;
            var minChange = isExpected ? MinChange / 2 : MinChange;
            var significance = isExpected ? ExpectedSignificance : Significance;
            // Tightest bound of the window, and length of the window for which it was determined.
            var (newest, measured) = (double.NegativeInfinity, 0);
            foreach (var length in Windows)
            {
                var window = length;
                while (window < Math.Min(MaxWindow, count) && Duration(window) < minDuration) window++;
                if (count < window + MinEarlier) return false;
                var duration = Duration(window);
                if (duration < minDuration) continue;
                var earlier = Math.Min(count, window + MaxEarlier);
                var reference = Tightest(window, earlier);
                newest = Math.Max(newest, Tightest(measured, window));
                measured = window;
                var late = reference - newest;
                if (late <= Margin(earlier, minChange, SkewErrorsLonger * skewError, resolution)) continue;
                // A wrong skew makes one direction late and the other early by the same amount, and the minimum round-trip time is unchanged.
                if (late + Math.Min(0, other.Lateness(window, earlier)) <= minChange + resolution) continue;
                if (late <= Quantile(window, earlier, reference, 1 - Math.Exp(-significance / window))) continue;
                var change = reference - Tightest(0, window - window / BoundaryShare);
                var typicalSince = Quantile(0, window, reference - change, 0.5);
                var typical = Quantile(window, earlier, reference, 0.5);
                if (!isExpected && typicalSince > (1 + MaxScatterGrowth / Math.Sqrt(window)) * typical && duration < MinDurationScattered) continue;
                _excessError += typical / (earlier - window) + typicalSince / window;
                _excess += change;
                _sinceChange = window;
                if (_sinceHidden < window) _hiddenError = 0;
                other.AddHiddenError(window, earlier);
                for (var i = 0; i < window; i++) Shift(i, i + 1, Math.Min(change, reference - _tightness[i]));
                return true;
            }
            return false;
        }

        // Increases the error after a change in the other direction. The delay in this direction may have changed, too, by less than the effect of a
        // wrong skew. The offset then moves by half of that change.
        void AddHiddenError(int window, int earlier)
        {
            var late = Math.Abs(Lateness(window, earlier));
            if (late <= Quantile(window, earlier, Tightest(window, earlier), 1 - Math.Exp(-HiddenSignificance / window))) return;
            _hiddenError += late / 2;
            _sinceHidden = 0;
        }

        // Enlarges the detected change if a tighter bound shows that the minimum delay is even shorter. Shortly after the detection, the minimum
        // delay is uncertain.
        void RefineReference(int count)
        {
            if (++_sinceShorter > Math.Min(count, MaxEarlier)) _sinceShorter = 0;
            if (_sinceShorter == 0) return;
            var more = _tightness[0] - Tightest(1, _sinceShorter);
            if (more <= 0) return;
            Shift(_sinceShorter, _history.Count, more);
            _referenceError += more / 2;
        }

        // Until a change is confirmed, relaxes a bound that is tighter than the earlier bounds to the level of the earlier bounds. The
        // change then affects the offset and not the skew.
        bool FindShorter(int count, double skewError, double resolution)
        {
            var earlier = Math.Min(count, ShorterWindow + MaxEarlier);
            // Excludes the recent bounds: if several of them became tighter in small steps, a comparison with them would hide the change.
            var reference = Tightest(ShorterWindow, earlier);
            var shorter = _tightness[0] - reference;
            int times = 0, first = 0;
            _shorter[_looks++ % ShorterWindow] = 0;
            for (var age = 1; age < Math.Min(_looks, ShorterWindow); age++)
                if (Withheld(age) > 0) (times, first) = (times + 1, age);
            // After one bound beyond the margin, any tighter bound counts as a confirmation.
            var margin = times > 0 ? 0 : Margin(earlier, MinChange, SkewErrorsShorter * skewError, resolution);
            if (shorter <= margin) return false;
            if (times == 0 && shorter <= LatenessShare * Quantile(ShorterWindow, earlier, reference, 0.5) / (earlier - ShorterWindow)) return false;
            _shorter[(_looks - 1) % ShorterWindow] = shorter;
            Shift(0, 1, -shorter);
            // The change may still be a clock step until enough exchanges show it and the first of them is old enough.
            if (times + 1 < ShorterCount || first < StepWindow - 1) return false;
            for (var age = 0; age <= first; age++) Shift(age, age + 1, Withheld(age));
            _sinceShorter = first + 1;
            // Earlier bounds that were tighter by less than the margin belong to the shorter path as well.
            for (var age = first + 1; age < ShorterWindow; age++)
                if (_tightness[age] > Tightest(age + 1, earlier)) _sinceShorter = age + 1;
            var change = Tightest(0, _sinceShorter) - Tightest(_sinceShorter, earlier);
            Shift(_sinceShorter, _history.Count, change);
            _referenceError += change / 2;
            _looks = 0;
            return true;
        }

        // Returns the amount in s by which a bound was relaxed.
        double Withheld(int age) => _shorter[(_looks - 1 - age) % ShorterWindow];

        TimeSpan Duration(int exchanges) => _history[0].Received - _history[exchanges - 1].Received;

        double Margin(int earlier, double minChange, double skewError, double resolution) =>
            minChange + resolution + skewError * ClockTicks.Seconds(Duration(earlier));

        // Returns a quantile of the lateness relative to the reference.
        double Quantile(int from, int to, double reference, double share)
        {
            for (var i = from; i < to; i++) _lateness[i - from] = reference - _tightness[i];
            Array.Sort(_lateness, 0, to - from);
            return _lateness[(int)Math.Ceiling(share * (to - from - 1))];
        }

        void Shift(int from, int to, double seconds)
        {
            var ticks = ClockTicks.Span(seconds).Ticks * _sign;
            for (var i = from; i < to; i++)
                _history.Shift(i, _sign > 0 ? ticks : 0, _sign > 0 ? 0 : ticks);
            for (var i = from; i < Math.Min(to, _tightness.Length); i++) _tightness[i] += seconds;
        }
    }
}
