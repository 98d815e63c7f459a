using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Frames
{
    /// <summary>
    /// Predicts a vector by one predictor per component, alone or in a mixture with polynomials of the vector. The weights are common to the
    /// three components. A repetition (<see cref="RepeatedVector"/>) replaces the mixture while its error is clearly smaller.
    /// </summary>
    /// <remarks>
    /// The predictors of the components are the prior: they have the full weight until samples have shown their error. Each sample shows the
    /// errors of the forecasts made one horizon before it; the weights minimise the mean square over the last 20 s
    /// (<see cref="MixtureWeights"/>). The three components have the same kind of noise and motion, so the weights are estimated three times as fast
    /// as for a joint, and an inaccurate forecast loses its weight within a second. Allocates nothing after construction.
    /// </remarks>
    sealed class VectorMixture
    {
        /// <summary>Regularisation towards the prior: with 0.05 and with 0.4, the maximum errors are larger.</summary>
        const double Regularisation = 0.2;

        /// <summary>
        /// Weight of the prior, as a multiple of its weight for a joint. It is larger because successive errors of a component are similar.
        /// </summary>
        const double PriorWeight = 8;

        /// <summary>
        /// Minimum evidence (<see cref="MixtureWeights.Evidence"/>) for the use of the weights while samples only scatter: one second of
        /// samples.
        /// </summary>
        const double MinEvidence = 0.05;

        /// <summary>Maximum interval in which samples are interpolated to score a forecast, s.</summary>
        const double MaxInterval = 0.3;

        /// <summary>Errors above this, in m or rad, are not scored: their squares would remain in every mean.</summary>
        const double MaxError = 1e9;

        /// <summary>Maximum number of forecasts that wait for their sample: half a second of samples at 180 Hz.</summary>
        const int Capacity = 96;

        /// <summary>Maximum displacement from the newest sample while samples only scatter, as a multiple of the usual error of hold.</summary>
        const double MaxDisplacement = 2;

        const int Components = 3, Hold = 1, Line = 2;

        /// <summary>Number of samples that the blend needs.</summary>
        const int MinRecent = 3;

        readonly VectorPolynomial[] _polynomials;
        readonly RecentVectors _recent;

        // Null without a mixture.
        readonly RepeatedVector _repeated;
        readonly VectorBlend _blend;
        readonly double _horizonCap;
        readonly MixtureWeights _weights;
        readonly double[] _prior;
        readonly double[] _errors;
        readonly ScatterDetector _scatter = new ScatterDetector();
        readonly DistanceLimit _distance = new DistanceLimit(Mixer.TimeConstant);

        // Forecasts that wait for a sample at or after their time.
        readonly RecyclingQueue<Expected> _waiting;
        double _newestTime, _newestOrder, _lineUntil;
        Vector3D _newest;

        /// <param name="main">The predictors of the components.</param>
        /// <param name="polynomials">
        /// Degree and history of the polynomials that are mixed with the prior. Hold and line must be the first two. If empty, the prior is used
        /// alone.
        /// </param>
        /// <param name="limits">Horizon cap and maximum gap.</param>
        /// <param name="blend">Time constant of the blend between two predictions, s; 0 disables the blend.</param>
        public VectorMixture(AxisPredictors main, (int Degree, int History)[] polynomials, PredictionLimits limits, double blend)
        {
            Main = main;
            _polynomials = Array.ConvertAll(polynomials, one => new VectorPolynomial(one.Degree, one.History));
            var samples = MinRecent;
            foreach (var (_, history) in polynomials) samples = Math.Max(samples, history + 1);
            _recent = new RecentVectors(samples, limits.MaximumGap);
            _repeated = polynomials.Length > 0 ? new RepeatedVector(limits) : null;
            _blend = new VectorBlend(blend);
            _horizonCap = limits.HorizonCap;
            _prior = new double[1 + polynomials.Length];
            _prior[0] = 1;
            _errors = new double[_prior.Length];
            _weights = new MixtureWeights(Regularisation, _prior);
            _waiting = new RecyclingQueue<Expected>(Capacity, () => new Expected(_prior.Length));
            Forget();
        }

        /// <summary>The predictors of the components, which are the prior of the mixture.</summary>
        public AxisPredictors Main { get; }

        /// <summary>Adds a sample. Samples may be added in any order. For the parameters, see <see cref="JointPredictor.Add"/>.</summary>
        public DropReason Add(double time, in Vector3D position, double order, double displayed)
        {
            var isBlended = _blend.IsNeeded(displayed) && _recent.Count > 0;
            var (shown, before) = (isBlended ? At(displayed) : default, Main.NewestTime);
            var reason = Main.Add(time, position, order, displayed);
            // Late samples improve the prior; the polynomials are valid without them.
            if (reason != DropReason.None || _polynomials.Length == 0 || !(order > _newestOrder)) return reason;
            Learn(time, position, order);
            if (isBlended) _blend.Start(displayed, shown, PredictedAt(displayed), before, _recent);
            return reason;
        }

        /// <summary>Returns the vector at a given time. Does not change the state.</summary>
        public Vector3D At(double time) => _blend.At(time, PredictedAt(time));

        Vector3D PredictedAt(double time)
        {
            // Between samples, the prior interpolates.
            if (_polynomials.Length == 0 || time <= Main.NewestTime) return Main.At(time);
            if (_repeated.IsUsed) return _repeated.At(time);
            if (_newestTime < _lineUntil) return Forecast(Line, time);
            if (_scatter.Scatters && _weights.Evidence < MinEvidence) return Main.Hold;
            var sum = default(Vector3D);
            for (var i = 0; i < _prior.Length; i++)
                if (_weights.Values[i] != 0) sum += Forecast(i, time) * _weights.Values[i];
            if (_distance.Factor < 1) sum = Forecast(Line, time) * (1 - _distance.Factor) + sum * _distance.Factor;
            if (!double.IsFinite(sum.X + sum.Y + sum.Z)) return Main.Hold;
            return _scatter.Scatters ? Bounded(sum) : sum;
        }

        Vector3D Forecast(int index, double time) =>
            index == 0 ? Main.At(time) : _polynomials[index - 1].At(Math.Min(time - _newestTime, _horizonCap));

        // Limits the displacement. In rare cases, the prior mistakes a large difference between two noisy samples for a change point and
        // extrapolates this difference.
        Vector3D Bounded(in Vector3D position)
        {
            var hold = Main.Hold;
            var displacement = position - hold;
            var max = MaxDisplacement * Math.Sqrt(Components * _weights.MeanSquare(Hold));
            return displacement.Length <= max ? position : hold + displacement * (max / displacement.Length);
        }

        /// <summary>Discards all samples and weights.</summary>
        public void Reset()
        {
            Main.Reset();
            Forget();
        }

        void Forget()
        {
            _weights.Reset(_prior);
            _scatter.Clear();
            _recent.Clear();
            _blend.Clear();
            _distance.Clear();
            _waiting.Clear();
            _repeated?.Reset();
            _newestTime = _newestOrder = _lineUntil = double.NegativeInfinity;
        }

        void Learn(double time, in Vector3D position, double order)
        {
            var interval = time - _newestTime;
            Score(time, position);
            _scatter.Add(position);
            if (_scatter.HasLeft && IsFirstMove(interval, position)) _lineUntil = time + Main.Horizon + interval;
            (_newestTime, _newestOrder, _newest) = (time, order, position);
            _repeated.Add(position, Main.Motion);
            _recent.Add(time, position);
            foreach (var polynomial in _polynomials) polynomial.Solve(_recent);
            // All forecasts from a single sample are equal to it.
            if (_recent.Count > 1) Expect(time + Main.Horizon, interval);
        }

        // The weights that result from noise at rest are unsuitable for a first move. After one horizon, they include the errors of this move.
        bool IsFirstMove(double interval, in Vector3D position)
        {
            var displacement = (position - _newest).Length * Main.Horizon / interval;
            return displacement * displacement > Mixer.FirstMoveRatio * Components * _weights.MeanSquare(Hold);
        }

        void Expect(double due, double interval)
        {
            var (expected, sum) = (_waiting.Append(), default(Vector3D));
            expected.Due = due;
            for (var i = 0; i < _prior.Length; i++)
            {
                expected.Forecasts[i] = Forecast(i, due);
                sum += expected.Forecasts[i] * _weights.Values[i];
            }
            (expected.Mixture, expected.Repeated) = (sum, _repeated.ForecastFor(due));
            _distance.Add(interval, (sum - expected.Forecasts[Line]).Length);
        }

        // The truth at the time of a forecast is interpolated between the two newest samples.
        void Score(double time, in Vector3D position)
        {
            var interval = time - _newestTime;
            var forgettingFactor = Math.Exp(-Math.Max(interval, 0) / (Components * Mixer.TimeConstant));
            var hasScored = false;
            for (; _waiting.Count > 0 && _waiting[0].Due <= time; _waiting.DropFirst())
            {
                var expected = _waiting[0];
                if (!(interval < MaxInterval) || expected.Due < _newestTime) continue;
                var fraction = (expected.Due - _newestTime) / interval;
                var truth = _newest + (position - _newest) * fraction;
                hasScored |= Score(expected.Forecasts, truth, forgettingFactor);
                _repeated.Score(expected.Repeated, expected.Mixture, truth, time);
            }
            if (hasScored) _weights.Solve(_prior, PriorWeight * (1 - forgettingFactor));
        }

        bool Score(Vector3D[] forecasts, in Vector3D truth, double forgettingFactor)
        {
            foreach (var forecast in forecasts)
                if (!((forecast - truth).Length < MaxError)) return false;
            for (var component = 0; component < Components; component++)
            {
                for (var i = 0; i < _prior.Length; i++) _errors[i] = (forecasts[i] - truth)[component];
                _weights.Learn(_errors, forgettingFactor);
            }
            return true;
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
