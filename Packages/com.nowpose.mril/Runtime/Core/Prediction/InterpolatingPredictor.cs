using System;

namespace Nowpose.Prediction
{
    /// <summary>Between its samples a joint is where they say; ahead of the newest it is where another predictor says.</summary>
    /// <remarks>
    /// For sources whose samples lie ahead of the display time: set-points, or a display time that lags. What the predictor
    /// says of the newest sample's own time may differ from it, since it smooths; the difference fades within the first
    /// milliseconds ahead, so that the joint does not jump where the display time overtakes the samples.
    /// </remarks>
    public sealed class InterpolatingPredictor : IJointPredictor
    {
        /// <summary>Samples that lie further back than this many are left to the predictor.</summary>
        const int Samples = 8;

        /// <summary>Short against every latency that is worth compensating, s.</summary>
        const double SeamTimeConstant = 0.005;

        readonly IJointPredictor _ahead;
        readonly PredictionLimits _limits;
        readonly SampleHistory _history = new SampleHistory(Samples);
        readonly SampleCurve _curve = new SampleCurve(Samples);
        double _seam;

        /// <param name="ahead">Says where the joint is later than its newest sample, and before its oldest.</param>
        /// <param name="limits">Position limits, and the gap over which nothing is known of the way.</param>
        public InterpolatingPredictor(IJointPredictor ahead, PredictionLimits limits)
        {
            _ahead = ahead ?? throw new ArgumentNullException(nameof(ahead));
            _limits = limits ?? throw new ArgumentNullException(nameof(limits));
        }

        /// <inheritdoc/>
        public double Hold => _ahead.Hold;

        /// <inheritdoc/>
        public double NewestTime => _ahead.NewestTime;

        /// <inheritdoc/>
        public SampleOutcome Add(in JointSample sample)
        {
            var outcome = _ahead.Add(sample);
            if (outcome != SampleOutcome.Accepted && outcome != SampleOutcome.Late) return outcome;
            _history.Add(sample);
            _curve.Clear();
            for (var age = _history.CountWithoutGap(_limits.MaximumGap) - 1; age >= 0; age--)
                _curve.Append(_history[age].Time, _history[age].Position);
            _curve.Complete();
            _seam = _history.NewestPosition - _ahead.At(_history.NewestTime).Position;
            return outcome;
        }

        /// <inheritdoc/>
        public JointPrediction At(double time)
        {
            if (_curve.Count > 1 && time >= _curve.Start && time <= _curve.End)
                return new JointPrediction(_limits.Clamp(_curve.At(time)), PredictionKind.Interpolated);
            var prediction = _ahead.At(time);
            var ahead = time - _history.NewestTime;
            if (!(ahead > 0) || _seam == 0 || prediction.Kind == PredictionKind.None) return prediction;
            return new JointPrediction(_limits.Clamp(prediction.Position + _seam * Math.Exp(-ahead / SeamTimeConstant)), prediction.Kind);
        }

        /// <inheritdoc/>
        public void Reset()
        {
            _ahead.Reset();
            _history.Clear();
            _curve.Clear();
            _seam = 0;
        }
    }
}
