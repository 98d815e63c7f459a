using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Forecasts that the present motion continues in the same way as an earlier, similar motion, for machines that repeat their motion.
    /// </summary>
    /// <remarks>
    /// Compares the newest samples with the history at the lags of greatest similarity, refines each lag to the best fit, and averages the
    /// continuations of the best three, weighted by their fit. Without a similar motion, it has no forecast. A <see cref="CandidateGate"/>
    /// decides whether the forecast is used.
    /// </remarks>
    sealed class TemplateForecaster : Forecaster
    {
        /// <summary>
        /// Duration of the newest motion that is compared with the history, in s. Within a shorter window, a straight line matches many positions; a
        /// longer window includes more of the preceding rest, whose duration varies.
        /// </summary>
        const double Window = 0.4;

        /// <summary>Minimum number of sampling intervals before the history starts. Their mean then determines the grid step.</summary>
        const int MinIntervals = 8;

        /// <summary>Minimum grid step, in s: the capacity of the history then covers the maximum lag of two minutes.</summary>
        const double MinStep = 0.02;

        /// <summary>
        /// Minimum number of samples in motion to compare: with fewer, the starts of different moves look the same, and only the duration of the
        /// rest before the moves would determine the match.
        /// </summary>
        const int MinMoving = 2;

        /// <summary>
        /// Maximum number of samples at a standstill for which a search is made. In a longer standstill, all parts of the history at rest are equal,
        /// so the matches would drift; their lags determine when the next move starts.
        /// </summary>
        const int MaxStill = 2;

        /// <summary>
        /// Maximum gap in the history, in s, even if the limits allow a longer one: the motion in a longer gap cannot be interpolated.
        /// </summary>
        const double MaxGap = 2;

        /// <summary>
        /// Maximum change of the sampling interval, as a factor; a larger change starts a new history. Twice the interval exceeds it. A lost sample
        /// does not, because a gap changes the mean interval by at most a factor of 1.2 (<see cref="MotionState"/>).
        /// </summary>
        const double MaxIntervalRatio = 1.6;

        readonly double _maximumGap;
        readonly double _matchInterval;
        readonly MotionHistory _history = new MotionHistory();
        readonly LagSearch _search;
        readonly MotionOverlay _overlay;
        readonly int[] _found = new int[LagSearch.Kept];
        readonly double[] _refined = new double[LagSearch.Kept];
        readonly double[] _lags = new double[LagSearch.Kept];
        readonly double[] _errors = new double[LagSearch.Kept];
        readonly double[] _offsets = new double[LagSearch.Kept];
        readonly double[] _weights = new double[LagSearch.Kept];
        double _interval;
        double _newestTime;
        double _newestPosition;
        int _matches;
        int _turn;
        double _matchedAt;

        /// <param name="limits">Limits with the maximum gap; a longer gap restarts the history.</param>
        /// <param name="matchInterval">
        /// Minimum interval between two comparisons with the history, in s; samples between them keep the last matches.
        /// </param>
        public TemplateForecaster(PredictionLimits limits, double matchInterval)
        {
            _maximumGap = Math.Min(limits.MaximumGap, MaxGap);
            _matchInterval = matchInterval;
            _overlay = new MotionOverlay(_history);
            _search = new LagSearch(_history);
            Reset();
        }

        public override int Samples => 2;

        /// <returns>False if the history contains no similar motion.</returns>
        public override bool Solve(MotionState motion)
        {
            // An overtaken sample is too late for the history.
            if (motion.IsNewest && motion.Samples.Count > 1) Update(motion);
            return _matches > 0;
        }

        public override double At(double ahead)
        {
            var position = 0.0;
            for (var i = 0; i < _matches; i++)
                if (_weights[i] > 0)
                    position += _weights[i] * (_history.At(_history.IndexOf(_newestTime + ahead) - _lags[i]) + _offsets[i]);
            return position - _newestPosition;
        }

        public override void Fill(double[] table, int start, int points)
        {
            for (var i = 0; i < points; i++) table[start + i] = -_newestPosition;
            for (var match = 0; match < _matches; match++)
            {
                if (_weights[match] == 0) continue;
                var (weight, offset, step) = (_weights[match], _offsets[match], ForecastTable.Step / _history.Step);
                var index = _history.IndexOf(_newestTime) - _lags[match];
                _history.AddTo(table, start, points, index, step, weight, offset);
            }
        }

        public override void Reset()
        {
            _interval = 0;
            _history.Start(0);
            _search.Start();
            Array.Clear(_found, 0, _found.Length);
            _matches = 0;
        }

        // At a smaller lag, the history does not cover the continuation.
        int MinLag => (int)Math.Ceiling(ForecastTable.Span / _history.Step) + MotionHistory.Margin;

        void Update(MotionState motion)
        {
            var before = _matches;
            _matches = 0;
            if (motion.Interval > _maximumGap) Reset();
            if (_interval == 0)
            {
                Begin(motion.Samples, motion.MeanInterval);
                return;
            }
            // A single gap does not change the mean interval enough to restart.
            if (motion.MeanInterval > MaxIntervalRatio * _interval || motion.MeanInterval * MaxIntervalRatio < _interval)
            {
                Reset();
                return;
            }
            (_newestTime, _newestPosition) = (motion.Samples.NewestTime, motion.Samples.NewestPosition);
            _history.Add(_newestTime, _newestPosition);
            _search.Update(MinLag);
            var isSoon = _newestTime - _matchedAt < _matchInterval;
            if (before > 0 && (isSoon || motion.Rest.StillSamples > MaxStill)) KeepMatches(before);
            else Match(motion);
        }

        // Keeps the matches between two searches and during a standstill.
        void KeepMatches(int matches)
        {
            for (var i = 0; i < matches; i++)
                if (!HasContinuation(_lags[i])) return;
            _matches = matches;
        }

        // The grid step is a multiple of the sampling interval, so that samples lie on grid points and need no interpolation.
        void Begin(SampleHistory samples, double interval)
        {
            if (samples.Count <= MinIntervals || samples.CountWithoutGap(_maximumGap) <= MinIntervals) return;
            _interval = interval;
            _history.Start(_interval * Math.Ceiling(MinStep / _interval - MotionHistory.Rounding));
            _search.Start();
            for (var i = MinIntervals; i >= 0; i--) _history.Add(samples[i].Time, samples[i].Position);
        }

        void Match(MotionState motion)
        {
            _matchedAt = _newestTime;
            _overlay.Take(motion.Samples, SamplesInWindow(motion));
            _turn = (_turn + 1) % LagSearch.Kept;
            var min = double.PositiveInfinity;
            for (var i = 0; i < _search.Count; i++)
            {
                MoveTo(i, _search.Lags[i]);
                // Matches keep their refined lags; one of them is refined again per search.
                if (_found[i] != _search.Lags[i] || i == _turn)
                    (_found[i], _refined[i]) = (_search.Lags[i], _overlay.Find(_search.Lags[i], MinLag));
                if (!_overlay.Compare(_refined[i]) || !HasContinuation(_refined[i])) continue;
                _lags[_matches] = _refined[i];
                _errors[_matches] = _overlay.MeanSquare;
                // The offset of the newest samples from the history is assumed to stay the same.
                _offsets[_matches] = _overlay.Offset;
                min = Math.Min(min, _errors[_matches++]);
            }
            Weigh(min);
        }

        // Moves the match of a lag to its new place among the best lags.
        void MoveTo(int place, int lag)
        {
            // The first call of Array.IndexOf would allocate a comparer.
            var i = place;
            while (i < _found.Length && _found[i] != lag) i++;
            if (i == _found.Length) return;
            (_found[place], _found[i]) = (_found[i], _found[place]);
            (_refined[place], _refined[i]) = (_refined[i], _refined[place]);
        }

        bool HasContinuation(double lag) => _history.Covers(_history.IndexOf(_newestTime) - lag)
            && _history.Covers(_history.IndexOf(_newestTime + ForecastTable.Span) - lag);

        // In motion, only the samples since the start of the motion are compared, because the duration of the preceding rest varies.
        static int SamplesInWindow(MotionState motion)
        {
            var newest = motion.Samples;
            var full = 1;
            while (full < newest.Count && newest[0].Time - newest[full].Time <= Window) full++;
            var moving = 0;
            while (moving + 1 < full && Math.Abs(newest[moving].Position - newest[moving + 1].Position) > motion.Rest.StillDistance) moving++;
            return moving < MinMoving ? full : Math.Min(full, moving + 2);
        }

        void Weigh(double min)
        {
            var total = 0.0;
            for (var i = 0; i < _matches; i++)
            {
                // The addend prevents a division of zero by zero after an exact match.
                var ratio = _errors[i] / (min + 1e-300) + 1;
                _weights[i] = 1 / (ratio * ratio);
                total += _weights[i];
            }
            for (var i = 0; i < _matches; i++) _weights[i] /= total;
        }
    }
}
