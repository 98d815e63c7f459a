using System;

namespace Nowpose.Prediction
{
    /// <summary>No prediction: the newest sample's position, as a display without compensation shows it.</summary>
    public sealed class HoldPredictor : IJointPredictor
    {
        readonly PredictionLimits _limits;
        readonly SampleHistory _history = new SampleHistory(1);

        /// <param name="limits">Only the position limits matter here.</param>
        public HoldPredictor(PredictionLimits limits) => _limits = limits ?? throw new ArgumentNullException(nameof(limits));

        /// <inheritdoc/>
        public double Hold => _history.NewestPosition;

        /// <inheritdoc/>
        public double NewestTime => _history.NewestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample) => _history.Add(sample);

        /// <inheritdoc/>
        public JointPrediction At(double time) =>
            _history.Count == 0 ? default : new JointPrediction(_limits.Clamp(Hold), PredictionKind.Held);

        /// <inheritdoc/>
        public void Reset() => _history.Clear();
    }
}
