using System;
using Nowpose.Prediction.Forecasting;

namespace Nowpose.Frames
{
    /// <summary>A predictor by name, for example <c>linear</c> or <c>gp</c>: the weighted sum of the newest samples (<see cref="PositionWeights"/>).</summary>
    sealed class VectorPolynomial : VectorForecaster
    {
        readonly BodyPart _part;
        readonly PositionWeights _weights;
        readonly Vector3D[] _vectors;
        readonly double[] _weightsAtTime;

        /// <param name="weights">Weights of this forecaster only.</param>
        public VectorPolynomial(BodyPart part, PositionWeights weights)
        {
            (_part, _weights) = (part, weights);
            (_vectors, _weightsAtTime) = (new Vector3D[weights.Samples], new double[weights.Samples]);
        }

        public override double Span => double.PositiveInfinity;

        public override int Samples => _weights.Samples;

        public override bool Solve(BodySamples samples, bool isElsewhere)
        {
            var count = Math.Min(samples.Timing.ConnectedSamples, Samples);
            if (count < _weights.MinSamples || !_weights.Update(samples.History, count)) return false;
            var newest = samples.History[0][_part];
            for (var i = 0; i < count; i++) _vectors[i] = samples.History[i][_part] - newest;
            return true;
        }

        public override Vector3D At(double ahead)
        {
            var sum = default(Vector3D);
            _weights.At(ahead, _weightsAtTime, 0);
            for (var i = 0; i < _weights.Count; i++) sum += _vectors[i] * _weightsAtTime[i];
            return sum;
        }
    }
}
