using System;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;
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
        /// Duration of the newest motion that is compared with the history, in s. Within a shorter window, a straight line matches many positions; a
        /// longer window includes more of the preceding rest, whose duration varies. With 0.2 s, the errors on recordings are 1.6 % larger; with 0.8 s,
        /// those of simulated motions 1.0 %.
        /// </summary>
        const double Window = 0.4;

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

        /// <summary>Mean square error that prevents a division of zero by zero after an exact match; negligible for every other match.</summary>
        const double MinMeanSquare = 1e-300;

        readonly int _components;
        readonly double _matchInterval;
        readonly MotionHistory _history;
        readonly LagSearch _search;
        readonly MotionOverlay _overlay;

        readonly int[] _found = new int[LagSearch.Kept];
        readonly double[] _refined = new double[LagSearch.Kept];
        readonly double[] _lags = new double[LagSearch.Kept];
        readonly double[] _errors = new double[LagSearch.Kept];
        readonly double[] _weights = new double[LagSearch.Kept];
        readonly double[] _offsets;
        int _starts;
        int _matches;
        int _refinedNext;
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
            if (before > 0 && (isSoon || motion.Rest.StillSamples > MaxStill)) KeepMatches(before);
            else Match(motion.Rest.StillDistance);
            return _matches > 0;
        }

        public override double At(double ahead, int component)
        {
            var (index, position) = (_history.IndexOf(Newest.Times[0] + ahead), 0.0);
            for (var i = 0; i < _matches; i++)
                position += _weights[i] * (_history.At(index - _lags[i], component) + _offsets[i * _components + component]);
            return position - Newest.Positions[component];
        }

        public override void Reset()
        {
            _history.Reset();
            _matches = 0;
        }

        PositionWindow Newest => _history.Newest;

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
            Array.Clear(_found, 0, _found.Length);
        }

        void Match(double stillDistance)
        {
            _matchedAt = Newest.Times[0];
            _overlay.Take(Newest.Times, Newest.Positions, SamplesInWindow(stillDistance));
            _refinedNext = (_refinedNext + 1) % LagSearch.Kept;
            var min = double.PositiveInfinity;
            for (var i = 0; i < _search.Count; i++)
            {
                MoveTo(i, _search.Lags[i]);
                // Matches keep their refined lags; one of them is refined again per search.
                if (_found[i] != _search.Lags[i] || i == _refinedNext)
                    (_found[i], _refined[i]) = (_search.Lags[i], _overlay.Find(_search.Lags[i], MinLag));
                if (!_overlay.Compare(_refined[i]) || !HasContinuation(_refined[i])) continue;
                _lags[_matches] = _refined[i];
                _errors[_matches] = _overlay.MeanSquare;
                // The offset of the newest samples from the history is assumed to stay the same.
                Array.Copy(_overlay.Offsets, 0, _offsets, _matches * _components, _components);
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

        bool HasContinuation(double lag) => _history.Covers(_history.IndexOf(Newest.Times[0]) - lag)
            && _history.Covers(_history.IndexOf(Newest.Times[0] + ForecastTable.Span) - lag);

        // In motion, only the samples since the start of the motion are compared, because the duration of the preceding rest varies.
        int SamplesInWindow(double stillDistance)
        {
            var full = 1;
            while (full < Newest.Count && Newest.Times[0] - Newest.Times[full] <= Window) full++;
            var moving = 0;
            while (moving + 1 < full && Newest.DisplacementAt(moving) > stillDistance) moving++;
            return moving < MinMoving ? full : Math.Min(full, moving + 2);
        }

        void Weigh(double min)
        {
            var total = 0.0;
            for (var i = 0; i < _matches; i++)
            {
                var ratio = _errors[i] / (min + MinMeanSquare) + 1;
                _weights[i] = 1 / (ratio * ratio);
                total += _weights[i];
            }
            for (var i = 0; i < _matches; i++) _weights[i] /= total;
        }
    }
}
