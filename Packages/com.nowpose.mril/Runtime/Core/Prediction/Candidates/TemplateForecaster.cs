using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Prediction.Candidates
{
    /// <summary>
    /// Template matching: forecasts that the present motion continues in the same way as earlier, similar motions, for machines that repeat their motion.
    /// </summary>
    /// <remarks>
    /// Compares the newest samples with the history at the lags of greatest similarity, refines each lag to the best fit, and averages the
    /// continuations of the best three, weighted by their fit. An object repeats a motion in all components together. One search for all components takes
    /// half the time of three searches, and finds repetitions in which one component moves after another more reliably. It finds none if only some of the
    /// components repeat, as on a pallet with many places.
    /// </remarks>
    sealed class TemplateForecaster : Forecaster
    {
        /// <summary>
        /// Duration of the newest motion that is compared with the history, in s; shorter if the kept samples do not reach so far. Within a shorter
        /// window, a straight line matches many positions; a longer window includes more of the preceding rest, whose duration varies. With 0.2 s, the
        /// errors on recordings are 1.6 % larger; with 0.8 s, those of simulated motions 1.0 %.
        /// </summary>
        const double Window = 0.4;

        /// <summary>
        /// Maximum RMS distance of the compared samples from the history, relative to the displacement in a grid step at the maximum speed. Without the limit,
        /// forecasts from a dissimilar past have such errors that the gate stays closed for several moves after a motion has begun to repeat, and the errors of
        /// simulated motions are 1.4 % larger. Measured without <see cref="LimitedFor"/>: with 0.0125, they are 1.2 % larger; with 0.05, the errors on recordings
        /// are 0.3 % larger.
        /// </summary>
        const double MaxDistanceRatio = 0.025;

        /// <summary>
        /// Length of the history in s from which on <see cref="MaxDistanceRatio"/> does not apply. Noisy or rounded samples never come within the limit, and
        /// until then, a motion that repeats has usually come within it.
        /// </summary>
        const double LimitedFor = 30;

        /// <summary>
        /// Minimum number of samples in motion to compare: with fewer, the starts of different moves look the same, and only the duration of the
        /// rest before the moves would determine the match.
        /// </summary>
        const int MinMoving = 2;

        readonly int _components;
        readonly double _matchInterval;
        readonly MotionHistory _history;
        readonly LagSearch _search;
        readonly MotionOverlay _overlay;

        readonly double[] _lags = new double[LagSearch.Kept];
        readonly double[] _errors = new double[LagSearch.Kept];
        readonly double[] _weights = new double[LagSearch.Kept];
        readonly double[] _offsets;
        MotionState _motion;
        int _starts;
        int _matches;
        double _matchedAt;

        /// <param name="history">The past of this motion, which candidates share.</param>
        /// <param name="matchInterval">
        /// Minimum interval between two comparisons with the history, in s; samples between them keep the last matches.
        /// </param>
        public TemplateForecaster(MotionHistory history, double matchInterval)
        {
            (_components, _history, _matchInterval) = (history.Components, history, matchInterval);
            _overlay = new MotionOverlay(history);
            _search = new LagSearch(history);
            _offsets = new double[LagSearch.Kept * _components];
        }

        /// <returns>False if the history contains no similar motion.</returns>
        public override bool Solve(MotionState motion)
        {
            _motion = motion;
            _history.Take(motion);
            var before = _matches;
            _matches = 0;
            if (!_history.HasStarted) return false;
            if (_starts != _history.Starts)
            {
                Start();
                return false;
            }
            _search.Update(MinLag);
            var isSoon = motion.NewestTime - _matchedAt < _matchInterval;
            // At a standstill, all parts of the history at rest are equal, so the matches would drift; their lags determine when the next move starts.
            if (before > 0 && !motion.IsPreviousWrong && (isSoon || motion.StillSamples > 1)) KeepMatches(before);
            else Match();
            return _matches > 0;
        }

        public override double At(double ahead, int component)
        {
            var (index, position) = (_history.IndexOf(_motion.NewestTime + ahead), 0.0);
            for (var i = 0; i < _matches; i++)
                position += _weights[i] * (_history.At(index - _lags[i], component) + _offsets[i * _components + component]);
            return position - _motion.Newest[component];
        }

        public override void Reset()
        {
            _history.Reset();
            _matches = 0;
        }

        // At a smaller lag, the history does not cover the continuation.
        int MinLag => (int)Math.Ceiling(ForecastTable.Span / _history.Step) + MotionHistory.Margin;

        // Keeps the matches between two searches and during a standstill.
        void KeepMatches(int matches)
        {
            for (var i = 0; i < matches; i++)
                if (!HasContinuation(_lags[i])) return;
            _matches = matches;
        }

        // The lags of an earlier history are wrong.
        void Start()
        {
            _starts = _history.Starts;
            _search.Start();
        }

        void Match()
        {
            _matchedAt = _motion.NewestTime;
            _overlay.Take(_motion, SamplesInWindow());
            var (min, minLag) = (double.PositiveInfinity, MinLag);
            var isLimited = (_history.End - _history.First) * _history.Step < LimitedFor;
            var maxDistance = isLimited ? MaxDistanceRatio * _motion.MaxSpeed * _history.Step : double.PositiveInfinity;
            for (var i = 0; i < _search.Count; i++)
            {
                var lag = _overlay.Find(_search.Lags[i], minLag);
                if (!_overlay.Compare(lag) || _overlay.MeanSquare > maxDistance * maxDistance || !HasContinuation(lag)) continue;
                _lags[_matches] = lag;
                _errors[_matches] = _overlay.MeanSquare;
                // The offset of the newest samples from the history is assumed to stay the same.
                for (var c = 0; c < _components; c++) _offsets[_matches * _components + c] = _overlay.OffsetOf(c);
                min = Math.Min(min, _errors[_matches++]);
            }
            Weigh(min);
        }

        bool HasContinuation(double lag) => _history.Covers(_history.IndexOf(_motion.NewestTime) - lag)
            && _history.Covers(_history.IndexOf(_motion.NewestTime + ForecastTable.Span) - lag);

        // In motion, only the samples since the start of the motion are compared, because the duration of the preceding rest varies.
        int SamplesInWindow()
        {
            var full = 1;
            while (full < _motion.Count && -_motion.Times[full] <= Window) full++;
            var moving = 0;
            while (moving + 1 < full && _motion.DistanceFromPrevious(moving) > _motion.StillDistance) moving++;
            return moving < MinMoving ? full : Math.Min(full, moving + 2);
        }

        void Weigh(double min)
        {
            var total = 0.0;
            for (var i = 0; i < _matches; i++)
            {
                // An exact match has the error 0.
                var ratio = _errors[i] > min ? _errors[i] / min + 1 : 2;
                _weights[i] = 1 / (ratio * ratio);
                total += _weights[i];
            }
            for (var i = 0; i < _matches; i++) _weights[i] /= total;
        }
    }
}
