using System;

namespace Nowpose.Prediction
{
    /// <summary>Passes on so many samples as tell something: of a source at 500 Hz every third.</summary>
    /// <remarks>
    /// Forecasts over a tenth of a second gain nothing from samples a millisecond apart: windows of a few samples would see
    /// their noise, and records of forecasts would not reach back to one that has come due. Hold stays the newest sample's.
    /// </remarks>
    public sealed class ThinnedPredictor : IJointPredictor
    {
        /// <summary>Samples of up to 180 Hz are all taken, s.</summary>
        const double LeastInterval = 0.0055;

        readonly IJointPredictor _inner;
        double _newestTime;
        double _newestPosition;

        public ThinnedPredictor(IJointPredictor inner)
        {
            _inner = inner ?? throw new ArgumentNullException(nameof(inner));
            Reset();
        }

        /// <inheritdoc/>
        public double Hold => _newestPosition;

        /// <inheritdoc/>
        public double NewestTime => _newestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            if (!(sample.Time > _newestTime)) return _inner.Add(sample);
            var taken = _inner.NewestTime;
            (_newestTime, _newestPosition) = (sample.Time, sample.Position);
            return sample.Time - taken < LeastInterval ? SampleOutcome.Accepted : _inner.Add(sample);
        }

        /// <inheritdoc/>
        public JointPrediction At(double time) => _inner.At(time);

        /// <inheritdoc/>
        public void Reset()
        {
            _inner.Reset();
            _newestTime = double.NegativeInfinity;
            _newestPosition = 0;
        }
    }
}
