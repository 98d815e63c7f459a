using System;

namespace Nowpose.Prediction
{
    /// <summary>For joints that turn without end and whose angle comes back from π to −π: predicts the angle that goes on.</summary>
    /// <remarks>A way of more than half a turn between two samples is taken for the shorter one the other way round.</remarks>
    public sealed class UnwrappedPredictor : IJointPredictor
    {
        const double Turn = 2 * Math.PI;

        readonly IJointPredictor _inner;
        double _newestOrder;
        double _unwrapped;
        double _shift;

        /// <param name="inner">Sees an angle without jumps, rad.</param>
        public UnwrappedPredictor(IJointPredictor inner)
        {
            _inner = inner ?? throw new ArgumentNullException(nameof(inner));
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _inner.Hold - _shift;

        /// <inheritdoc/>
        public double NewestTime => _inner.NewestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var isFirst = double.IsNegativeInfinity(_newestOrder);
            var position = isFirst ? sample.Position : sample.Position + Turn * Math.Round((_unwrapped - sample.Position) / Turn);
            if (sample.Order > _newestOrder) (_newestOrder, _unwrapped, _shift) = (sample.Order, position, position - sample.Position);
            return _inner.Add(new JointSample(sample.Time, position, sample.Order, sample.Velocity, sample.Acceleration));
        }

        /// <inheritdoc/>
        /// <returns>In the newest sample's turn; beyond π where the joint goes on beyond it.</returns>
        public JointPrediction At(double time)
        {
            var prediction = _inner.At(time);
            return prediction.Kind == PredictionKind.None ? prediction : new JointPrediction(prediction.Position - _shift, prediction.Kind);
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _inner.Reset();
            _newestOrder = double.NegativeInfinity;
            _unwrapped = _shift = 0;
        }
    }
}
