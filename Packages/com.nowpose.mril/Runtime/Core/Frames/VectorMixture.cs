using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Frames
{
    /// <summary>
    /// Forecasts a vector by a mixture with weights that are common to its three components. A repetition (<see cref="RepeatedVector"/>) replaces the
    /// mixture while its error is clearly smaller.
    /// </summary>
    /// <remarks>
    /// Like the <see cref="Mixer"/> of a joint, but all forecasters are weighted sums of the newest samples, so the mixture is one too: its weights are
    /// computed once for all three components. Each sample shows the errors of the forecasts made one horizon before it; the weights minimise the mean
    /// square over the last 20 s (<see cref="MixtureWeights"/>). The three components have the same kind of noise and motion, so the weights are
    /// estimated three times as fast as for a joint. Allocates nothing after construction.
    /// </remarks>
    sealed class VectorMixture : VectorForecaster
    {
        /// <summary>
        /// Regularisation towards the prior. With 0.2, the errors of simulated motions are 0.3 % (position) and 1.1 % (rotation) larger; with 0.05, they
        /// are 0.1 and 0.4 % smaller, and more motions have a larger error than the best fixed predictor.
        /// </summary>
        const double Regularisation = 0.1;

        /// <summary>
        /// Weight of the prior, as a multiple of its weight for a joint. It is larger because successive errors of a component are similar. With 1 or 8,
        /// the errors change by at most 0.3 %.
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
        /// Maximum distance of a repetition from a sample that it explains, relative to the displacement of the sample. A fast motion that repeats is not
        /// a jump.
        /// </summary>
        const double MaxRepeatedRatio = 0.5;

        /// <summary>Maximum interval in which samples are interpolated to score a forecast, s.</summary>
        const double MaxInterval = 0.3;

        /// <summary>Errors above this, in m or rad, are not scored: their squares would remain in every mean.</summary>
        const double MaxError = 1e9;

        /// <summary>Maximum number of forecasts that wait for their sample: half a second of samples at 180 Hz.</summary>
        const int Capacity = 96;

        /// <summary>Maximum displacement from the newest sample while samples only scatter, as a multiple of the usual error of hold.</summary>
        const double MaxDisplacement = 2;

        /// <summary>Maximum difference from the first vector that counts as rounding, in m or rad. A vector that never changes needs no forecast.</summary>
        const double Rounding = 1e-9;

        const int Components = 3, Hold = VectorForecasts.Hold, Line = VectorForecasts.Line;

        readonly BodyPart _part;
        readonly VectorForecasts _forecasts;
        readonly MixtureWeights _weights;
        readonly double[] _prior, _errors;
        readonly RepeatedVector _repeated;
        readonly VectorChangePoints _changePoints;
        readonly ScatterDetector _scatter = new ScatterDetector();
        readonly JumpDetector _jumps;
        readonly DistanceLimit _distance = new DistanceLimit(Mixer.TimeConstant);

        // Forecasts that wait for a sample at or after their time.
        readonly RecyclingQueue<Expected> _waiting;

        // The forecast that is displayed: points of a forecast table relative to the newest sample, the three components of each point together.
        readonly double[] _section = new double[Components * ForecastTable.Points];
        readonly int _points;

        Vector3D _first, _newest;
        double _newestTime, _lineUntil;
        bool _hasChanged;

        /// <param name="forecasters">
        /// Result of <see cref="VectorForecasts.NewForecasters"/>. Objects that are sampled at the same times may use it in turn.
        /// </param>
        /// <param name="limits">Horizon cap and maximum gap.</param>
        public VectorMixture(BodyPart part, PositionWeights[] forecasters, PredictionLimits limits)
        {
            (_part, _forecasts) = (part, new VectorForecasts(part, forecasters));
            _jumps = new JumpDetector(part);
            _changePoints = new VectorChangePoints(part);
            _prior = _forecasts.Prior();
            _errors = new double[_prior.Length];
            _weights = new MixtureWeights(Regularisation, _prior);
            _repeated = new RepeatedVector(limits);
            _waiting = new RecyclingQueue<Expected>(Capacity, () => new Expected(_prior.Length));
            _points = ForecastTable.PointsUpTo(limits.HorizonCap);
            Forget();
        }

        public override double Span => ForecastTable.Span;

        public override int Samples => 2;

        public override bool HasJumped => _jumps.HasJumped;

        public override bool Solve(BodySamples samples, bool isElsewhere)
        {
            var vector = samples.History[0][_part];
            if (double.IsNegativeInfinity(_newestTime)) _first = vector;
            if (samples.IsNewest) DetectJump(samples, vector, isElsewhere);
            _hasChanged |= Math.Max(Math.Max(Math.Abs(vector.X - _first.X), Math.Abs(vector.Y - _first.Y)), Math.Abs(vector.Z - _first.Z)) > Rounding;
            if (_hasChanged)
            {
                if (samples.IsNewest) Learn(samples, vector);
                else _forecasts.Prepare(samples, _changePoints.Detector, HasJumped);
                FillSection();
            }
            else if (samples.IsNewest)
            {
                (_newestTime, _newest) = (samples.History.NewestTime, vector);
                _changePoints.Add(samples, HasJumped);
            }
            return samples.Timing.ConnectedSamples >= 2;
        }

        public override Vector3D At(double ahead)
        {
            if (_repeated.IsUsed && !HasJumped) return _repeated.At(_newestTime + ahead) - _newest;
            var time = new TableTime(ahead);
            return new Vector3D(time.Read(_section, 0, Components), time.Read(_section, 1, Components), time.Read(_section, 2, Components));
        }

        public override void Reset() => Forget();

        void Forget()
        {
            _weights.Reset(_prior);
            _scatter.Clear();
            _changePoints.Reset();
            _distance.Clear();
            _waiting.Clear();
            _repeated.Reset();
            Array.Clear(_section, 0, _section.Length);
            _newestTime = _lineUntil = double.NegativeInfinity;
            _jumps.Clear();
            _newest = default;
            _hasChanged = false;
        }

        void Learn(BodySamples samples, in Vector3D vector)
        {
            var (time, horizon) = (samples.History.NewestTime, samples.Timing.Horizon);
            var interval = time - _newestTime;
            // After a gap or a jump, earlier forecasts are wrong for a reason that no forecaster can know.
            if (samples.Timing.ConnectedSamples == 1 || HasJumped)
            {
                _waiting.Clear();
                _scatter.Clear();
            }
            Score(time, vector);
            _scatter.Add(vector);
            if (_scatter.HasLeft && IsFirstMove(interval, horizon, vector)) _lineUntil = time + horizon + interval;
            (_newestTime, _newest) = (time, vector);
            _repeated.Add(vector, time, samples.Timing.MeanInterval);
            _changePoints.Add(samples, HasJumped);
            _forecasts.Prepare(samples, _changePoints.Detector, HasJumped);
            if (Math.Min(samples.Timing.ConnectedSamples, _jumps.SamplesSince) >= MinScored) Expect(horizon, interval);
        }

        void DetectJump(BodySamples samples, in Vector3D vector, bool isElsewhere)
        {
            if (samples.Timing.ConnectedSamples < 2)
            {
                _jumps.Clear();
                return;
            }
            var (time, displacement) = (samples.History.NewestTime, vector - _newest);
            // The stamps of two close samples may be inaccurate.
            _jumps.Add(displacement, Math.Max(time - _newestTime, samples.Timing.MeanInterval), isElsewhere);
            if (HasJumped && _repeated.IsUsed && (_repeated.At(time) - vector).Length < MaxRepeatedRatio * displacement.Length) _jumps.Dismiss();
        }

        // The weights that result from noise at rest are unsuitable for a first move. After one horizon, they include the errors of this move.
        bool IsFirstMove(double interval, double horizon, in Vector3D vector)
        {
            var displacement = (vector - _newest).Length * horizon / interval;
            return displacement * displacement > Mixer.FirstMoveRatio * Components * _weights.MeanSquare(Hold);
        }

        void Expect(double horizon, double interval)
        {
            var (expected, time, sum) = (_waiting.Append(), new TableTime(horizon), default(Vector3D));
            expected.Due = _newestTime + horizon;
            for (var i = 0; i < _prior.Length; i++)
            {
                var forecast = _forecasts.At(i, horizon, time);
                expected.Forecasts[i] = _newest + forecast;
                sum += forecast * _weights.Values[i];
            }
            (expected.Mixture, expected.Repeated) = (_newest + sum, _repeated.ForecastFor(expected.Due));
            _distance.Add(interval, (sum - _forecasts.LineSpeed * horizon).Length);
        }

        void FillSection()
        {
            Array.Clear(_section, 0, _section.Length);
            var isLine = _newestTime < _lineUntil;
            if (!isLine && _scatter.Scatters && _weights.Evidence < MinEvidence) return;
            var factor = isLine ? 0 : _distance.Factor;
            var max = _scatter.Scatters && !isLine ? MaxDisplacement * Math.Sqrt(Components * _weights.MeanSquare(Hold)) : double.PositiveInfinity;
            for (int point = 1, place = Components; point < _points; point++, place += Components)
            {
                var line = _forecasts.LineSpeed * (point * ForecastTable.Step);
                var sum = factor > 0 ? _forecasts.MixtureAt(point, line, _weights.Values) * factor + line * (1 - factor) : line;
                var length = sum.Length;
                if (!double.IsFinite(length))
                {
                    Array.Clear(_section, 0, _section.Length);
                    return;
                }
                // In rare cases, a large difference between two noisy samples counts as a change point, and the line extrapolates this difference.
                if (length > max) sum *= max / length;
                (_section[place], _section[place + 1], _section[place + 2]) = (sum.X, sum.Y, sum.Z);
            }
        }

        // The truth at the time of a forecast is interpolated between the two newest samples.
        void Score(double time, in Vector3D vector)
        {
            var interval = time - _newestTime;
            var forgettingFactor = Math.Exp(-Math.Max(interval, 0) / (Components * Mixer.TimeConstant));
            var hasScored = false;
            for (; _waiting.Count > 0 && _waiting[0].Due <= time; _waiting.DropFirst())
            {
                var expected = _waiting[0];
                if (!(interval < MaxInterval) || expected.Due < _newestTime) continue;
                var fraction = (expected.Due - _newestTime) / interval;
                var truth = _newest + (vector - _newest) * fraction;
                hasScored |= Score(expected.Forecasts, truth, forgettingFactor);
                // After a break, the mixture is wrong for a moment, which proves nothing for a repetition if a line is not.
                var isLineBetter = (expected.Forecasts[Line] - truth).Length < (expected.Mixture - truth).Length;
                _repeated.Score(expected.Repeated, isLineBetter ? expected.Forecasts[Line] : expected.Mixture, truth, time);
            }
            if (hasScored) _weights.Solve(_prior, PriorWeight * (1 - forgettingFactor));
        }

        bool Score(Vector3D[] forecasts, in Vector3D truth, double forgettingFactor)
        {
            foreach (var forecast in forecasts)
                if (!((forecast - truth).Length < MaxError)) return false;
            if (!Differ(forecasts)) return false;
            for (var component = 0; component < Components; component++)
            {
                for (var i = 0; i < _prior.Length; i++) _errors[i] = (forecasts[i] - truth)[component];
                _weights.Learn(_errors, forgettingFactor);
            }
            return true;
        }

        // From a rest without noise, all forecasts are equal. Their error at a start would hide the differences between the forecasters for seconds.
        static bool Differ(Vector3D[] forecasts)
        {
            foreach (var forecast in forecasts)
                if ((forecast - forecasts[Line]).Length > Rounding) return true;
            return false;
        }

        sealed class Expected
        {
            public Expected(int forecasts) => Forecasts = new Vector3D[forecasts];

            /// <summary>Time of the forecasts, in s.</summary>
            public double Due { get; set; }

            /// <summary>One vector per forecast.</summary>
            public Vector3D[] Forecasts { get; }

            /// <summary>Weighted sum of the forecasts.</summary>
            public Vector3D Mixture { get; set; }

            public RepeatedVector.Forecast Repeated { get; set; }
        }
    }
}
