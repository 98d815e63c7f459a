using System;
using Nowpose.Prediction.Candidates;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Prediction.Mixing
{
    /// <summary>
    /// Forecasts by a mixture: the weighted sum of forecasts whose weights minimise its recent error. A candidate replaces the mixture while
    /// its error is clearly smaller.
    /// </summary>
    /// <remarks>
    /// No single forecaster is best for every motion: the paper's quadratic is better on clean swings, a straight line on many real machines.
    /// Each new sample shows the errors of the forecasts that were made one horizon before it, the weights are solved from these errors
    /// (<see cref="MixtureWeights"/>), and the tables of all forecasts, one of which is displayed, are filled. The components of an object have the same
    /// weights: they have the same kind of noise and motion, so the weights are estimated three times as fast as for a joint.
    /// </remarks>
    sealed class Mixture : Forecaster
    {
        /// <summary>
        /// Time constant of the forgetting factor of the weights, in s: with 10 or 40 s, the errors of joints change by at most 0.2 %; with 40 s, the
        /// errors of objects are 1.5 % larger.
        /// </summary>
        public const double TimeConstant = 20;

        /// <summary>
        /// Regularisation towards the prior. With 0.2, the errors are 0.3 % (recordings) and 1.3 % (simulated) larger; with 0.05, those of recordings
        /// are 0.1 % larger.
        /// </summary>
        const double Regularisation = 0.1;

        /// <summary>
        /// Weight of the prior, as a multiple of the number of samples in <see cref="MixtureWeights"/>: successive errors of a component are similar, so
        /// they are less evidence than their number. With 1, the errors change by at most 0.2 %.
        /// </summary>
        const double PriorWeight = 4;

        /// <summary>
        /// Minimum evidence (<see cref="MixtureWeights.Evidence"/>) for the use of the weights while samples only scatter: one second of
        /// samples.
        /// </summary>
        const double MinEvidence = 0.05;

        /// <summary>
        /// Minimum number of connected samples from which a forecast is scored. From two samples, all forecasts are the same line, whose large error
        /// would hide the differences between the forecasters for seconds. With 2 or 5, the errors change by at most 0.6 %.
        /// </summary>
        const int MinScored = 3;

        /// <summary>
        /// Maximum distance of a candidate's forecast from a sample that it explains, relative to the displacement of the sample. A fast motion that
        /// repeats is not a jump.
        /// </summary>
        const double MaxExplainedRatio = 0.5;

        /// <summary>
        /// Threshold for a first move, which is a motion much faster than the noise before it: minimum ratio of the squared displacement within one
        /// horizon to the mean square error of hold. For a motion that continues at constant speed, the ratio is 1.
        /// </summary>
        const double FirstMoveRatio = 30;

        /// <summary>
        /// Factor by which the line multiplies the speed directly after a change point that did not increase it. Without the factor, the errors on
        /// recordings are 0.4 % larger.
        /// </summary>
        const double SpeedRatioAfterStop = 0.5;

        /// <summary>Maximum interval in which samples are interpolated to score a forecast, s.</summary>
        const double MaxInterval = 0.5;

        /// <summary>Errors above this, in m or rad, are not scored: their squares would remain in every mean.</summary>
        const double MaxError = 1e9;

        /// <summary>Maximum number of forecasts that wait for their sample: half a second of samples at 180 Hz.</summary>
        const int Capacity = 96;

        /// <summary>
        /// Maximum displacement from the newest sample while samples only scatter, as a multiple of their mean distance: the forecasters would amplify the
        /// noise. With 0.5 or 2, the errors change by at most 0.1 %.
        /// </summary>
        const double MaxScatterRatio = 1;

        /// <summary>Maximum difference that counts as rounding, in m or rad. A position that never changes needs no forecast.</summary>
        const double Rounding = 1e-9;

        const int Hold = MixedForecasters.Hold, Line = MixedForecasters.Line;

        readonly int _components, _points;
        readonly PredictionLimits _limits;
        readonly PredictionParts _parts;
        readonly MixedForecasters _forecasters;
        readonly Candidate[] _candidates;
        readonly MixtureWeights _weights;
        readonly ChangePointDetector _changePoints;
        readonly ScatterDetector _scatter;
        readonly JumpDetector _jumps;
        readonly DistanceLimit _distance = new DistanceLimit(TimeConstant);
        readonly double[] _errors, _first, _truth;

        // Forecasts that wait for a sample at or after their time.
        readonly RecyclingQueue<Expectation> _waiting;

        // The displayed forecast.
        readonly double[] _section;

        double _lineUntil;
        bool _hasChanged, _wasReported;

        /// <param name="limits">Horizon cap, and for a joint the limits of its drive.</param>
        /// <param name="forecasters">Forecasters of the mixture, which other motions may use in turn.</param>
        /// <param name="candidates">Forecasters that may replace the mixture.</param>
        /// <param name="jumps">Detector of jumps.</param>
        public Mixture(int components, PredictionLimits limits, PredictionParts parts, MixedForecasters forecasters, Candidate[] candidates, JumpDetector jumps)
        {
            (_components, _limits, _parts, _forecasters, _candidates, _jumps) = (components, limits, parts, forecasters, candidates, jumps);
            _points = ForecastTable.PointsUpTo(limits.HorizonCap);
            _weights = new MixtureWeights(Regularisation, forecasters.Prior(isReported: false));
            _changePoints = new ChangePointDetector(components);
            _scatter = new ScatterDetector(components);
            _errors = new double[forecasters.Count];
            (_first, _truth) = (new double[components], new double[components]);
            _waiting = new RecyclingQueue<Expectation>(Capacity, () => new Expectation(components, forecasters.Count, candidates.Length));
            _section = new double[ForecastTable.Points * components];
            Reset();
        }

        public override int Samples => 2;

        public override int MaxSamples => _forecasters.MaxSamples;

        public override double Span => ForecastTable.Span;

        public override bool HasJumped => _jumps.HasJumped;

        public override bool Solve(MotionState motion)
        {
            if (motion.IsNewest)
            {
                DetectJump(motion);
                DetectChange(motion);
                AddChangePoint(motion);
                if (_hasChanged) Learn(motion);
            }
            if (_hasChanged) Forecast(motion);
            return motion.Timing.ConnectedSamples >= 2;
        }

        public override double At(double ahead, int component) => new TableTime(ahead).Read(_section, 0, component, _components);

        public override void Reset()
        {
            foreach (var candidate in _candidates) candidate.Reset();
            _forecasters.Reset();
            _weights.Reset(_forecasters.Prior(isReported: false));
            _changePoints.Reset();
            _scatter.Clear();
            _jumps.Reset();
            _distance.Clear();
            _waiting.Clear();
            Array.Clear(_section, 0, _section.Length);
            _lineUntil = double.NegativeInfinity;
            _hasChanged = _wasReported = false;
        }

        bool Uses(PredictionParts part) => (_parts & part) != 0;

        void DetectJump(MotionState motion)
        {
            if (!Uses(PredictionParts.Jumps)) return;
            _jumps.Add(motion);
            if (!HasJumped) return;
            var max = MaxExplainedRatio * Vectors.Distance(motion.Newest, motion.Previous);
            foreach (var candidate in _candidates)
                if (candidate.IsUsed && candidate.DistanceFrom(motion, _points) < max) _jumps.Dismiss();
        }

        void DetectChange(MotionState motion)
        {
            if (double.IsNegativeInfinity(motion.PreviousTime)) Array.Copy(motion.Newest, _first, _components);
            for (var c = 0; c < _components; c++) _hasChanged |= Math.Abs(motion.Newest[c] - _first[c]) > Rounding;
        }

        void AddChangePoint(MotionState motion)
        {
            if (HasJumped) _changePoints.AddJump();
            else _changePoints.Add(motion);
        }

        void Learn(MotionState motion)
        {
            var interval = motion.NewestTime - motion.PreviousTime;
            // After a gap or a jump, earlier forecasts are wrong for a reason that no forecaster can know.
            if (motion.Timing.ConnectedSamples == 1 || HasJumped)
            {
                _waiting.Clear();
                _scatter.Clear();
            }
            if (HasJumped) _weights.Restore();
            else if (_jumps.IsUnconfirmed) _weights.Save();
            Score(motion, interval);
            if (Uses(PredictionParts.Scatter)) _scatter.Add(motion.Newest);
            if (_scatter.HasLeft && IsFirstMove(motion, interval)) _lineUntil = motion.NewestTime + motion.Timing.Horizon + interval;
            foreach (var candidate in _candidates) candidate.Add(motion, _points);
        }

        // The weights that result from noise at rest are unsuitable for a first move. After one horizon, they include the errors of this move.
        bool IsFirstMove(MotionState motion, double interval)
        {
            var displacement = Vectors.Distance(motion.Newest, motion.Previous) * motion.Timing.Horizon / interval;
            return displacement * displacement > FirstMoveRatio * _components * _weights.MeanSquare(Hold);
        }

        void Forecast(MotionState motion)
        {
            var samples = Math.Min(motion.Count, _jumps.SamplesSince);
            if (Uses(PredictionParts.ChangePoints)) samples = Math.Min(samples, _changePoints.SamplesSince);
            var factor = motion.Count < 2 || HasJumped ? 0 : samples == 1 && !_changePoints.SpeedIncreased ? SpeedRatioAfterStop : 1;
            _forecasters.Fill(motion, samples, factor, _points);
            if (motion.IsNewest && Math.Min(motion.Count, _jumps.SamplesSince) >= MinScored) Expect(motion);
            FillSection(motion);
        }

        // Stores the forecasts for one horizon ahead, to be scored when a sample at or after that time has arrived.
        void Expect(MotionState motion)
        {
            var (expected, horizon, distance) = (_waiting.Append(), motion.Timing.Horizon, 0.0);
            var time = new TableTime(horizon);
            expected.Due = motion.NewestTime + horizon;
            expected.WasStill = motion.Standstill.Samples > 0;
            for (var c = 0; c < _components; c++)
            {
                var (sum, line) = (0.0, _forecasters.At(Line, time, c));
                for (var i = 0; i < _errors.Length; i++)
                {
                    var forecast = _forecasters.At(i, time, c);
                    expected.Forecasts[i * _components + c] = motion.Newest[c] + forecast;
                    sum += _weights.Values[i] * forecast;
                }
                (expected.From[c], expected.Mixture[c]) = (motion.Newest[c], motion.Newest[c] + sum);
                distance += (sum - line) * (sum - line);
            }
            for (var i = 0; i < _candidates.Length; i++) expected.HasCandidate[i] = _candidates[i].TryForecast(time, motion, expected.Candidates[i]);
            if (Uses(PredictionParts.DistanceLimit)) _distance.Add(motion.NewestTime - motion.PreviousTime, Math.Sqrt(distance));
        }

        void FillSection(MotionState motion)
        {
            Array.Clear(_section, 0, _section.Length);
            var isStill = motion.Standstill.Samples > 0;
            var candidate = HasJumped ? null : BestCandidate(isStill);
            if (candidate != null) Array.Copy(candidate.Table, _section, _points * _components);
            else FillMixture(motion);
            Array.Clear(_section, 0, _components);
        }

        Candidate BestCandidate(bool isStill)
        {
            Candidate best = null;
            var min = double.PositiveInfinity;
            foreach (var candidate in _candidates)
            {
                var ratio = candidate.ErrorRatio(isStill);
                if (ratio < min) (best, min) = (candidate, ratio);
            }
            return best;
        }

        void FillMixture(MotionState motion)
        {
            // The weights of the last seconds would displace a constant velocity if they include hold.
            var isLine = motion.NewestTime < _lineUntil || (Uses(PredictionParts.ChangePoints) && _changePoints.IsSteady);
            if (!isLine && _scatter.Scatters && _weights.Evidence < MinEvidence) return;
            if (isLine) _forecasters.AddTo(_section, Line, 1, _points);
            else
            {
                var weights = _weights.Values;
                for (var i = Line; i < weights.Length; i++)
                    if (weights[i] != 0) _forecasters.AddTo(_section, i, weights[i] * _distance.Factor, _points);
                if (_distance.Factor < 1) _forecasters.AddTo(_section, Line, 1 - _distance.Factor, _points);
                if (_scatter.Scatters) Limit(MaxScatterRatio * _scatter.Noise);
            }
            if (_components == 1 && motion.Count > 1) ForecastTable.Limit(_section, _points, motion.Velocity[0], motion.Timing.Interval, _limits);
            foreach (var position in _section)
            {
                if (double.IsFinite(position)) continue;
                Array.Clear(_section, 0, _section.Length);
                return;
            }
        }

        void Limit(double max)
        {
            for (int point = 1, start = _components; point < _points; point++, start += _components)
            {
                var squares = 0.0;
                for (var c = 0; c < _components; c++) squares += _section[start + c] * _section[start + c];
                if (!(squares > max * max)) continue;
                for (var c = 0; c < _components; c++) _section[start + c] *= max / Math.Sqrt(squares);
            }
        }

        // The truth at the time of a forecast is interpolated between the two newest samples.
        void Score(MotionState motion, double interval)
        {
            var forgettingFactor = Math.Exp(-Math.Max(interval, 0) / (_components * TimeConstant));
            var hasScored = false;
            for (; _waiting.Count > 0 && _waiting[0].Due <= motion.NewestTime; _waiting.DropFirst())
            {
                var expected = _waiting[0];
                if (!(interval < MaxInterval) || expected.Due < motion.PreviousTime) continue;
                var fraction = (expected.Due - motion.PreviousTime) / interval;
                for (var c = 0; c < _components; c++) _truth[c] = motion.Previous[c] + (motion.Newest[c] - motion.Previous[c]) * fraction;
                hasScored |= Score(expected, _truth, forgettingFactor);
                ScoreCandidates(expected, _truth, motion.NewestTime);
            }
            var isReported = !double.IsNaN(motion.ReportedVelocity + motion.ReportedAcceleration);
            if (hasScored || isReported != _wasReported) _weights.Solve(_forecasters.Prior(isReported), PriorWeight * (1 - forgettingFactor));
            _wasReported = isReported;
        }

        bool Score(Expectation expected, double[] truth, double forgettingFactor)
        {
            var (forecasts, differ) = (expected.Forecasts, false);
            for (var i = 0; i < forecasts.Length; i += _components)
            {
                if (!(Vectors.Distance(forecasts, i, truth, 0, _components) < MaxError)) return false;
                differ |= Vectors.Distance(forecasts, i, forecasts, Line * _components, _components) > Rounding;
            }
            // From a rest without noise, all forecasts are equal. Their error at a start would hide the differences between the forecasters for seconds.
            if (!differ) return false;
            for (var c = 0; c < _components; c++)
            {
                for (var i = 0; i < _errors.Length; i++) _errors[i] = forecasts[i * _components + c] - truth[c];
                _weights.Learn(_errors, forgettingFactor);
            }
            return true;
        }

        void ScoreCandidates(Expectation expected, double[] truth, double time)
        {
            // After a break, the mixture is wrong for a moment, which proves nothing for a candidate if a line is not.
            var error = Math.Min(Vectors.Distance(expected.Mixture, truth), Vectors.Distance(truth, 0, expected.Forecasts, Line * _components, _components));
            for (var i = 0; i < _candidates.Length; i++)
                if (expected.HasCandidate[i]) _candidates[i].Score(expected.Candidates[i], error, truth, expected.From, expected.WasStill, time);
        }

        /// <summary>Forecasts for one time. The components of each position are adjacent.</summary>
        sealed class Expectation
        {
            public Expectation(int components, int forecasts, int candidates)
            {
                (Forecasts, Mixture, From) = (new double[forecasts * components], new double[components], new double[components]);
                (Candidates, HasCandidate) = (new double[candidates][], new bool[candidates]);
                for (var i = 0; i < candidates; i++) Candidates[i] = new double[components];
            }

            /// <summary>Time of the forecasts, in s.</summary>
            public double Due { get; set; }

            public double[] Forecasts { get; }

            /// <summary>Weighted sum of the forecasts.</summary>
            public double[] Mixture { get; }

            public double[][] Candidates { get; }

            public bool[] HasCandidate { get; }

            /// <summary>Position of the sample that was the newest when the forecasts were made.</summary>
            public double[] From { get; }

            /// <summary>Whether the positions stood still then.</summary>
            public bool WasStill { get; set; }
        }
    }
}
