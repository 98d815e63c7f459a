using System;
using Nowpose.Prediction.Stacking;

namespace Nowpose.Prediction.Repetition
{
    /// <summary>For machines that repeat themselves: the motion goes on as it did when it last was like this.</summary>
    /// <remarks>
    /// The newest samples are laid over the history at the lags where it resembles them most, each lag is refined until they
    /// fit best, and the best three go on, weighted by their fit. Without such a place there is no prediction; whether to
    /// trust one is for a gate to say. A sample costs one pass over the lags, a frame reads one table.
    /// </remarks>
    public sealed class TemplatePredictor : IJointPredictor
    {
        /// <summary>What follows a match must be known as far as a table spans: so many grid steps beside.</summary>
        const int StepsBesideSpan = 4;

        /// <summary>How fast the coarse comparison forgets, s.</summary>
        const double Forgetting = 0.25;

        /// <summary>How much of the newest motion is laid over the history, s.</summary>
        const double Window = 0.4;

        const int MostSamples = 24;
        const int FewestSamples = 8;

        /// <summary>The grid is no finer than this, s.</summary>
        const double FinestStep = 0.02;

        /// <summary>A way below this share of the greatest lately is rest.</summary>
        const double RestShare = 1e-3;

        const int FewestMoving = 2;

        /// <summary>After so many samples at rest another search finds nothing new.</summary>
        const int LongRest = 16;

        const double Fading = 0.998;
        const double GreatestWayOfSense = 1e50;
        const double IntervalLearning = 0.05;
        const double LongestShare = 3;

        /// <summary>The history is not filled over a longer one, s.</summary>
        const double LongestGap = 2;

        /// <summary>A match whose square is this much worse than the best's is no match.</summary>
        const double WorstMatch = 3;

        /// <summary>Another rhythm of samples than the grid was made for starts it anew.</summary>
        const double RhythmChange = 1.6;

        readonly PredictionLimits _limits;
        readonly SampleHistory _newest = new SampleHistory(MostSamples);
        readonly MotionHistory _history = new MotionHistory();
        readonly LagSearch _search = new LagSearch();
        readonly MotionOverlay _overlay;
        readonly double[] _lags = new double[LagSearch.Kept];
        readonly double[] _errors = new double[LagSearch.Kept];
        readonly double[] _offsets = new double[LagSearch.Kept];
        readonly double[] _intervals = new double[FewestSamples];
        readonly double[] _table = new double[ForecastGrid.Points];
        double _interval;
        double _rhythm;
        double _greatestWay;
        double _least;
        int _matches;
        int _rested;

        /// <param name="limits">Bounds of time and position.</param>
        public TemplatePredictor(PredictionLimits limits)
        {
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
            _overlay = new MotionOverlay(_history, _newest);
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _newest.NewestPosition;

        /// <inheritdoc/>
        public double NewestTime => _newest.NewestTime;

        /// <inheritdoc/>
        /// <remarks>A sample that was overtaken is refused: the history has passed it.</remarks>
        public SampleOutcome Add(in JointSample sample)
        {
            if (_newest.Count > 0 && sample.Order < _newest[0].Order) return SampleOutcome.TooOld;
            var outcome = _newest.Add(sample);
            if (outcome != SampleOutcome.Accepted) return outcome;
            if (_newest.Count > 1) Follow();
            return outcome;
        }

        /// <inheritdoc/>
        /// <returns><see cref="PredictionKind.None"/> where the motion resembles nothing before.</returns>
        public JointPrediction At(double time)
        {
            if (_matches == 0) return new JointPrediction(Hold, PredictionKind.None);
            var ahead = Math.Min(time - NewestTime, _limits.HorizonCap);
            var kind = ahead <= 0 ? PredictionKind.Interpolated : ahead < time - NewestTime ? PredictionKind.Held : PredictionKind.Predicted;
            return new JointPrediction(_limits.Clamp(Hold + ForecastGrid.Read(_table, 0, ahead)), kind);
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _newest.Clear();
            Restart();
        }

        void Restart()
        {
            _interval = 0;
            _history.Start(0);
            _search.Reset();
            _matches = 0;
            _greatestWay = 0;
            _rested = 0;
        }

        // Nearer than this the history does not know yet what followed.
        int LeastLag => (int)Math.Ceiling(ForecastGrid.Span / _history.Step) + StepsBesideSpan;

        void Follow()
        {
            var before = _matches;
            _matches = 0;
            var interval = _newest[0].Time - _newest[1].Time;
            var way = Math.Abs(_newest[0].Position - _newest[1].Position);
            // What overflows when it is squared would be remembered for ever.
            if (interval > Math.Min(_limits.MaximumGap, LongestGap) || !(way < GreatestWayOfSense)) Restart();
            if (_interval == 0)
            {
                Begin();
                return;
            }
            // One gap is no other rhythm.
            _interval += IntervalLearning * (Math.Min(interval, LongestShare * _rhythm) - _interval);
            if (_interval > RhythmChange * _rhythm || _interval * RhythmChange < _rhythm)
            {
                Restart();
                return;
            }
            _history.Add(_newest[0].Time, _newest[0].Position);
            _search.Follow(_history, LeastLag, Math.Exp(-_history.Step / Forgetting));
            _greatestWay = Math.Max(Fading * _greatestWay, way);
            _rested = way <= RestShare * _greatestWay ? _rested + 1 : 0;
            if (before > 0 && _rested > LongRest) Rest(before);
            else Match();
        }

        // After a while at rest nothing tells one place from another: the matches stay what they were, and time goes on.
        void Rest(int matches)
        {
            for (var i = 0; i < matches; i++)
                if (!KnowsWhatFollowed(_lags[i])) return;
            _matches = matches;
            Tabulate(_least);
        }

        // The grid takes the samples' own rhythm, so that it falls on them and interpolates nothing.
        void Begin()
        {
            if (_newest.Count <= FewestSamples || _newest.CountWithoutGap(_limits.MaximumGap) <= FewestSamples) return;
            for (var i = 0; i < FewestSamples; i++) _intervals[i] = _newest[i].Time - _newest[i + 1].Time;
            Array.Sort(_intervals);
            _interval = _rhythm = _intervals[FewestSamples / 2];
            _history.Start(_rhythm * Math.Ceiling(FinestStep / _rhythm - 1e-6));
            for (var i = FewestSamples; i >= 0; i--) _history.Add(_newest[i].Time, _newest[i].Position);
        }

        void Match()
        {
            var samples = SamplesInWindow();
            _least = double.PositiveInfinity;
            for (var i = 0; i < _search.Count; i++)
            {
                if (!_overlay.TryFind(_search.Lags[i], LeastLag, samples) || !KnowsWhatFollowed(_overlay.Lag)) continue;
                _lags[_matches] = _overlay.Lag;
                _errors[_matches] = _overlay.MeanSquare;
                // What the newest samples lie off the history goes on lying off.
                _offsets[_matches] = _overlay.Offset;
                _least = Math.Min(_least, _errors[_matches++]);
            }
            if (_matches > 0) Tabulate(_least);
        }

        bool KnowsWhatFollowed(double lag) => _history.Covers(_history.IndexOf(NewestTime) - lag)
            && _history.Covers(_history.IndexOf(NewestTime + ForecastGrid.Span) - lag);

        // In motion the samples since its start decide: how long the joint rested before is not how it moves now.
        int SamplesInWindow()
        {
            var full = 1;
            while (full < _newest.Count && _newest[0].Time - _newest[full].Time <= Window) full++;
            var moving = 0;
            while (moving + 1 < full && Math.Abs(_newest[moving].Position - _newest[moving + 1].Position) > RestShare * _greatestWay) moving++;
            return moving < FewestMoving ? full : Math.Min(full, moving + 2);
        }

        void Tabulate(double least)
        {
            Array.Clear(_table, 0, _table.Length);
            var total = 0.0;
            for (var i = 0; i < _matches; i++)
            {
                if (_errors[i] > WorstMatch * least) continue;
                var weight = 1 / Math.Pow(_errors[i] / (least + 1e-300) + 1, 2);
                total += weight;
                for (var point = 0; point < ForecastGrid.Points; point++)
                {
                    var index = _history.IndexOf(NewestTime + point * ForecastGrid.Step) - _lags[i];
                    _table[point] += weight * (_history.At(index, out _) + _offsets[i] - Hold);
                }
            }
            for (var point = 0; point < ForecastGrid.Points; point++) _table[point] /= total;
        }
    }
}
