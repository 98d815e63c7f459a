using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;

namespace Nowpose.Frames
{
    /// <summary>
    /// Predicts a vector: by one predictor per component, or by the sum of several forecasts with common weights for the three components.
    /// </summary>
    /// <remarks>
    /// The first forecast is the prior: it has all the weight until samples have shown its error. Each sample gives the errors of the
    /// forecasts made one horizon before it; the weights minimise the mean square over the last 20 s (<see cref="MixtureWeights"/>).
    /// The components of a vector share noise and motion, so they learn the weights three times as fast as a joint, and a forecast
    /// that is bad for this frame loses its weight within a second. Allocates nothing after construction.
    /// </remarks>
    sealed class VectorMixture
    {
        /// <summary>Time constant of the forgetting factor, s: that of the mixture of a joint.</summary>
        const double Memory = 20;

        /// <summary>Regularisation towards the first forecast: with 0.05 or 0.4, the largest errors grow.</summary>
        const double Regularisation = 0.2;

        /// <summary>Weight of the prior relative to that for a joint, because successive errors of a component are similar.</summary>
        const double PriorWeight = 8;

        /// <summary>Share of the memory that must be filled before the weights are used for samples that only scatter: one second.</summary>
        const double MinEvidence = 0.05;

        /// <summary>Maximum interval in which samples are interpolated to score a forecast, s.</summary>
        const double MaxInterval = 0.3;

        /// <summary>Errors above this, in m or rad, are not scored: their squares would remain in every mean.</summary>
        const double MaxError = 1e9;

        /// <summary>Maximum number of forecasts that wait for their sample: half a second of samples at 180 Hz.</summary>
        const int Capacity = 96;

        /// <summary>Maximum displacement from samples that only scatter, as a multiple of the usual error of hold.</summary>
        const double MaxDisplacement = 2;

        const int Components = 3, Hold = 1;

        readonly AxisPredictors[] _forecasts;
        readonly MixtureWeights _weights;
        readonly double[] _prior;
        readonly double[] _errors;
        readonly ScatterDetector _scatter = new ScatterDetector();

        // Forecasts that wait for their time: a queue of times, and for each of them one vector per forecast.
        readonly double[] _due = new double[Capacity];
        readonly Vector3D[] _expected;
        int _first, _count;
        double _newestTime, _newestOrder;
        Vector3D _newest;

        /// <param name="forecasts">The prior, hold, and any others; or one, which is used alone.</param>
        public VectorMixture(AxisPredictors[] forecasts)
        {
            _forecasts = forecasts;
            _prior = new double[forecasts.Length];
            _prior[0] = 1;
            _errors = new double[forecasts.Length];
            _weights = new MixtureWeights(Regularisation, _prior);
            _expected = new Vector3D[Capacity * forecasts.Length];
            Forget();
        }

        /// <summary>The first forecast.</summary>
        public AxisPredictors Main => _forecasts[0];

        /// <summary>Adds a sample in any order; the parameters are those of <see cref="JointPredictor.Add"/>.</summary>
        /// <returns>The outcome, or <see cref="SampleOutcome.StartedAnew"/> if it is that of any predictor.</returns>
        public SampleOutcome Add(double time, in Vector3D position, double order, double displayed)
        {
            var outcome = Main.Add(time, position, order, displayed);
            for (var i = 1; i < _forecasts.Length; i++)
                if (_forecasts[i].Add(time, position, order, displayed) == SampleOutcome.StartedAnew) outcome = SampleOutcome.StartedAnew;
            if (outcome == SampleOutcome.Accepted && _forecasts.Length > 1 && order > _newestOrder) Learn(time, position, order);
            return outcome;
        }

        /// <summary>Returns the vector at a time. Does not change the state.</summary>
        public Vector3D At(double time)
        {
            if (_scatter.Scatters && _weights.Evidence < MinEvidence) return Main.Hold;
            var sum = default(Vector3D);
            for (var i = 0; i < _forecasts.Length; i++)
                if (_weights.Values[i] != 0) sum += _forecasts[i].At(time) * _weights.Values[i];
            if (!double.IsFinite(sum.X + sum.Y + sum.Z)) return Main.Hold;
            return _scatter.Scatters ? Bounded(sum) : sum;
        }

        // A rare large difference of two noisy samples looks like a change point to the first forecast, which extrapolates it.
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
            foreach (var forecast in _forecasts) forecast.Reset();
            Forget();
        }

        void Forget()
        {
            _weights.Reset(_prior);
            _scatter.Clear();
            _first = _count = 0;
            _newestTime = _newestOrder = double.NegativeInfinity;
        }

        void Learn(double time, in Vector3D position, double order)
        {
            Score(time, position);
            (_newestTime, _newestOrder, _newest) = (time, order, position);
            _scatter.Add(position);
            Expect(time + Main.Horizon);
        }

        void Expect(double due)
        {
            if (_count == Capacity) DropFirst();
            var place = (_first + _count++) % Capacity;
            _due[place] = due;
            for (var i = 0; i < _forecasts.Length; i++) _expected[place * _forecasts.Length + i] = _forecasts[i].At(due);
        }

        // The truth at the time of a forecast is interpolated between the two newest samples.
        void Score(double time, in Vector3D position)
        {
            var interval = time - _newestTime;
            var keeping = Math.Exp(-Math.Max(interval, 0) / (Components * Memory));
            var hasScored = false;
            for (; _count > 0 && _due[_first] <= time; DropFirst())
            {
                if (!(interval < MaxInterval) || _due[_first] < _newestTime) continue;
                var share = (_due[_first] - _newestTime) / interval;
                hasScored |= Score(_first, _newest + (position - _newest) * share, keeping);
            }
            if (hasScored) _weights.Solve(_prior, PriorWeight * (1 - keeping));
        }

        bool Score(int place, in Vector3D truth, double keeping)
        {
            var first = place * _forecasts.Length;
            for (var i = 0; i < _forecasts.Length; i++)
                if (!((_expected[first + i] - truth).Length < MaxError)) return false;
            for (var component = 0; component < Components; component++)
            {
                for (var i = 0; i < _forecasts.Length; i++) _errors[i] = (_expected[first + i] - truth)[component];
                _weights.Learn(_errors, keeping);
            }
            return true;
        }

        void DropFirst()
        {
            _first = (_first + 1) % Capacity;
            _count--;
        }
    }
}
