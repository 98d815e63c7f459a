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

        readonly MeasuredBounds _bounds;
        readonly double[] _shorter = new double[ShorterWindow];
        double _excess, _excessError, _referenceError, _hiddenError;
        int _sinceChange, _sinceHidden, _sinceShorter, _looks;

        /// <param name="sign">1 for the bounds below the offset, from requests; −1 for the bounds above it, from replies.</param>
        public MinDelay(int sign, BoundsHistory history) => _bounds = new MeasuredBounds(sign, history, MaxCount);

        /// <summary>Current minimum delay minus the smallest known minimum delay, s; zero or more.</summary>
        public double Excess => _excess;

        /// <summary>Uncertainty of the corrections, s.</summary>
        public double Error => _excessError + _referenceError + _hiddenError;

        /// <inheritdoc cref="MeasuredBounds.Count"/>
        public int Count => _bounds.Count;

        /// <inheritdoc cref="MeasuredBounds.Tightest"/>
        public double Tightest(int from, int to) => _bounds.Tightest(from, to);

        // _sinceHidden and _shorter need no reset, because they are read only with a hidden error and up to _looks.
        public void Reset()
        {
            _bounds.Clear();
            _excess = _excessError = _referenceError = _hiddenError = 0;
            _sinceChange = _sinceShorter = _looks = 0;
        }

        /// <inheritdoc cref="MeasuredBounds.Measure"/>
        public void Measure(OffsetCurve curve) => _bounds.Measure(curve);

        /// <summary>Searches the measured bounds for a change.</summary>
        /// <param name="other">The other direction, measured relative to the same curve.</param>
        /// <param name="skewError">Standard error of the curve's slope.</param>
        /// <param name="resolution">Resolution of the control clock, s. Bounds move by this amount even if the path does not change.</param>
        /// <returns>Number of exchanges since the detected change; 0 if no change was detected.</returns>
        public int Update(MinDelay other, double skewError, double resolution)
        {
            _sinceChange++;
            _sinceHidden++;
            if (Count < MinEarlier + ShorterWindow) return 0;
            if (_excess > 0) ReduceExcess();
            if (_sinceShorter > 0) RefineReference();
            if (FindLonger(other, skewError, resolution)) return _sinceChange;
            return FindShorter(skewError, resolution) ? _sinceShorter : 0;
        }

        // Returns the lateness of a window's tightest bound relative to the tightest earlier bound; negative if it is tighter.
        double Lateness(int window, int earlier) => Tightest(window, earlier) - Tightest(0, window);

        // Reduces the excess if the newest bound, corrected by it, is tighter than all earlier bounds: the excess was then too large.
        void ReduceExcess()
        {
            var violation = Math.Min(_excess, _bounds[0] - Tightest(1, Count));
            if (violation <= 0) return;
            // A remaining excess below half the minimum change is caused by individual late exchanges, not by a path change, so it is removed.
            if (_excess - violation < MinChange / 2) violation = _excess;
            // A small violation means that the excess was overestimated; a large violation means that the path has changed again at this exchange.
            var isEstimate = violation < 3 * _excessError;
            _bounds.Shift(0, isEstimate ? Math.Min(_sinceChange, Count) : 1, -violation);
            _excessError *= 1 - violation / _excess;
            _excess -= violation;
            if (!isEstimate) _sinceChange = 1;
        }

        bool FindLonger(MinDelay other, double skewError, double resolution)
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
                while (window < Math.Min(MaxWindow, Count) && _bounds.Duration(window) < minDuration) window++;
                if (Count < window + MinEarlier) return false;
                var duration = _bounds.Duration(window);
                if (duration < minDuration) continue;
                var earlier = Math.Min(Count, window + MaxEarlier);
                var reference = Tightest(window, earlier);
                newest = Math.Max(newest, Tightest(measured, window));
                measured = window;
                var late = reference - newest;
                if (late <= Margin(earlier, minChange, SkewErrorsLonger * skewError, resolution)) continue;
                // A wrong skew makes one direction late and the other early by the same amount, and the minimum round-trip time is unchanged. While
                // the rate of a clock changes, the tightest bounds of the two directions come from different times, so round-trip times are used.
                // They include the error of a recent correction of the other direction.
                var longer = isExpected
                    ? late + Math.Min(0, other.Lateness(window, earlier))
                    : _bounds.MinRoundTrip(0, window) - _bounds.MinRoundTrip(window, earlier);
                if (longer <= minChange + resolution) continue;
                if (late <= _bounds.Quantile(window, earlier, reference, 1 - Math.Exp(-significance / window))) continue;
                var change = reference - Tightest(0, window - window / BoundaryShare);
                var typicalSince = _bounds.Quantile(0, window, reference - change, 0.5);
                var typical = _bounds.Quantile(window, earlier, reference, 0.5);
                if (!isExpected && typicalSince > (1 + MaxScatterGrowth / Math.Sqrt(window)) * typical && duration < MinDurationScattered) continue;
                _excessError += typical / (earlier - window) + typicalSince / window;
                _excess += change;
                _sinceChange = window;
                if (_sinceHidden < window) _hiddenError = 0;
                other.AddHiddenError(window, earlier);
                for (var i = 0; i < window; i++) _bounds.Shift(i, i + 1, Math.Min(change, reference - _bounds[i]));
                return true;
            }
            return false;
        }

        // Increases the error after a change in the other direction. The delay in this direction may have changed, too, by less than the effect of a
        // wrong skew. The offset then moves by half of that change.
        void AddHiddenError(int window, int earlier)
        {
            var late = Math.Abs(Lateness(window, earlier));
            if (late <= _bounds.Quantile(window, earlier, Tightest(window, earlier), 1 - Math.Exp(-HiddenSignificance / window))) return;
            _hiddenError += late / 2;
            _sinceHidden = 0;
        }

        // Enlarges the detected change if a tighter bound shows that the minimum delay is even shorter. Shortly after the detection, the minimum
        // delay is uncertain.
        void RefineReference()
        {
            if (++_sinceShorter > Math.Min(Count, MaxEarlier)) _sinceShorter = 0;
            if (_sinceShorter == 0) return;
            var more = _bounds[0] - Tightest(1, _sinceShorter);
            if (more <= 0) return;
            _bounds.Shift(_sinceShorter, _bounds.All, more);
            _referenceError += more / 2;
        }

        // Until a change is confirmed, relaxes a bound that is tighter than the earlier bounds to the level of the earlier bounds. The
        // change then affects the offset and not the skew.
        bool FindShorter(double skewError, double resolution)
        {
            var earlier = Math.Min(Count, ShorterWindow + MaxEarlier);
            // Excludes the recent bounds: if several of them became tighter in small steps, a comparison with them would hide the change.
            var reference = Tightest(ShorterWindow, earlier);
            var shorter = _bounds[0] - reference;
            int times = 0, first = 0;
            _shorter[_looks++ % ShorterWindow] = 0;
            for (var age = 1; age < Math.Min(_looks, ShorterWindow); age++)
                if (Withheld(age) > 0) (times, first) = (times + 1, age);
            // After one bound beyond the margin, any tighter bound counts as a confirmation.
            var margin = times > 0 ? 0 : Margin(earlier, MinChange, SkewErrorsShorter * skewError, resolution);
            if (shorter <= margin) return false;
            if (times == 0 && shorter <= LatenessShare * _bounds.Quantile(ShorterWindow, earlier, reference, 0.5) / (earlier - ShorterWindow)) return false;
            _shorter[(_looks - 1) % ShorterWindow] = shorter;
            _bounds.Shift(0, 1, -shorter);
            // The change may still be a clock step until enough exchanges show it and the first of them is old enough.
            if (times + 1 < ShorterCount || first < StepWindow - 1) return false;
            for (var age = 0; age <= first; age++) _bounds.Shift(age, age + 1, Withheld(age));
            _sinceShorter = first + 1;
            // Earlier bounds that were tighter by less than the margin belong to the shorter path as well.
            for (var age = first + 1; age < ShorterWindow; age++)
                if (_bounds[age] > Tightest(age + 1, earlier)) _sinceShorter = age + 1;
            var change = Tightest(0, _sinceShorter) - Tightest(_sinceShorter, earlier);
            _bounds.Shift(_sinceShorter, _bounds.All, change);
            _referenceError += change / 2;
            _looks = 0;
            return true;
        }

        // Returns the amount in s by which a bound was relaxed.
        double Withheld(int age) => _shorter[(_looks - 1 - age) % ShorterWindow];

        double Margin(int earlier, double minChange, double skewError, double resolution) =>
            minChange + resolution + skewError * ClockTicks.Seconds(_bounds.Duration(earlier));
    }
}
