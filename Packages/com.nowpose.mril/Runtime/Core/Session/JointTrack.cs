using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Prediction.Planning;

namespace Nowpose.Session
{
    /// <summary>One joint's samples on their way to its predictor: tells a sample that was overtaken from a clock that went back.</summary>
    /// <remarks>
    /// Both arrive with a stamp that is not newer than the newest. Taking a sample of a stepped clock for an overtaken one
    /// tears the section apart, so a late sample waits for the next: if that one is newer, it was overtaken and goes to
    /// its place; if that one is late too, the source's time went back and the history starts anew with the two.
    /// </remarks>
    sealed class JointTrack
    {
        readonly BlendedPredictor _predictor;
        readonly PlannedPredictor _planned;
        JointSample _late;
        bool _hasLate;

        public JointTrack(PredictionSettings settings, JointLimits joint)
        {
            var limits = settings.LimitsOf(joint);
            _planned = new PlannedPredictor(settings.Create(joint), limits);
            _predictor = new BlendedPredictor(_planned, limits, settings.IsHold ? 0 : ClockTicks.Seconds(settings.Blend));
        }

        public bool HasSample => !double.IsNegativeInfinity(NewestTime);

        /// <summary>Seconds since the epoch; negative infinity before the first sample.</summary>
        public double NewestTime => _predictor.NewestTime;

        /// <summary>The newest sample's position.</summary>
        public double Hold => _predictor.Hold;

        public JointPrediction At(double time) => _predictor.At(time);

        /// <param name="overtaken">What became of the sample that had waited for this one; late while there was none, or it still waits.</param>
        public SampleOutcome Add(in JointSample sample, out SampleOutcome overtaken)
        {
            overtaken = SampleOutcome.Late;
            if (sample.Order > _predictor.NewestTime) return AddNewer(sample, out overtaken);
            // The same message twice, or a source that stamps more coarsely than it samples: neither is about time going back.
            if (sample.Order == _predictor.NewestTime) return SampleOutcome.Duplicate;
            if (_hasLate) return StartAnew(sample);
            _late = sample;
            _hasLate = true;
            return SampleOutcome.Late;
        }

        /// <param name="path">Null when what was planned is off.</param>
        /// <param name="start">The plan's stamp, s since the epoch.</param>
        public void Follow(PlannedPath path, double start)
        {
            if (path == null) _planned.DropPlan();
            else _planned.Follow(path, start);
            _predictor.Renew();
        }

        public void Reset()
        {
            _predictor.Reset();
            _hasLate = false;
        }

        SampleOutcome AddNewer(in JointSample sample, out SampleOutcome overtaken)
        {
            overtaken = _hasLate ? _predictor.Add(_late) : SampleOutcome.Late;
            _hasLate = false;
            return _predictor.Add(sample);
        }

        SampleOutcome StartAnew(in JointSample sample)
        {
            var first = _late;
            Reset();
            _predictor.Add(first);
            return _predictor.Add(sample);
        }
    }
}
