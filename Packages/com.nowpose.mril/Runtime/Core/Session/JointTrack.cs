using System;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Prediction.Planning;

namespace Nowpose.Session
{
    /// <summary>One joint's samples on their way to its predictor: tells samples that were overtaken from a clock that went back.</summary>
    /// <remarks>
    /// Both arrive with stamps that are not newer than the newest. Taking a sample of a stepped clock for an overtaken one tears
    /// the section apart, and taking an overtaken one for a stepped clock throws away all that was learned. So late samples wait:
    /// when a newer one comes they were overtaken and go to their places; when they tell by their number, or by positions
    /// where the joint was not, that time went back, the history starts anew with them.
    /// </remarks>
    sealed class JointTrack
    {
        readonly BlendedPredictor _predictor;
        readonly PlannedPredictor _planned;
        readonly LateSamples _late = new LateSamples();
        readonly RecentSamples _recent = new RecentSamples();
        double _newestOrder = double.NegativeInfinity;

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

        /// <summary>Whether the last sample added told that the source's time went back: all before is forgotten.</summary>
        public bool HasStartedAnew { get; private set; }

        public JointPrediction At(double time) => _predictor.At(time);

        /// <param name="useless">Samples that had waited, and were of no use now that they came to their places.</param>
        /// <returns>Late when it waits.</returns>
        public SampleOutcome Add(in JointSample sample, out UselessSamples useless)
        {
            useless = default;
            HasStartedAnew = false;
            if (sample.Order > _newestOrder) return AddNewer(sample, out useless);
            // The same message twice, or a source that stamps more coarsely than it samples: neither is about time going back.
            if (sample.Order == _newestOrder || _recent.Contains(sample) || _late.Contains(sample)) return SampleOutcome.Duplicate;
            if (!_late.IsContinuedBy(sample)) TakeLate(out useless);
            _late.Add(sample, _recent.Contradict(sample));
            if (!_late.TellThatTimeWentBack(_newestOrder)) return SampleOutcome.Late;
            StartAnew();
            return SampleOutcome.Accepted;
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
            Forget();
            _late.Clear();
        }

        SampleOutcome AddNewer(in JointSample sample, out UselessSamples useless)
        {
            TakeLate(out useless);
            return Take(sample);
        }

        void TakeLate(out UselessSamples useless)
        {
            useless = default;
            foreach (ref readonly var late in _late.All) useless = useless.With(Take(late));
            _late.Clear();
        }

        void StartAnew()
        {
            Forget();
            TakeLate(out _);
            HasStartedAnew = true;
        }

        SampleOutcome Take(in JointSample sample)
        {
            _newestOrder = Math.Max(_newestOrder, sample.Order);
            _recent.Add(sample);
            return _predictor.Add(sample);
        }

        void Forget()
        {
            _predictor.Reset();
            _recent.Clear();
            _newestOrder = double.NegativeInfinity;
        }
    }
}
