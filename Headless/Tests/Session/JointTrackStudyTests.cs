using Nowpose.Kinematics;
using Nowpose.Prediction;
using Nowpose.Session;
using Nowpose.Studies;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>What a predictor loses by getting its samples as a session hands them over; seeds that nothing was tuned on.</summary>
public class JointTrackStudyTests
{
    static readonly int[] Seeds = [9001, 9002];
    static readonly PredictionSettings Settings = new("adaptive", blendMs: 0);

    [TestCase(20)]
    [TestCase(10)]
    public void WirelessNetwork_SamplesOvertakeEachOther_NothingIsLost(double samplingMs)
    {
        foreach (var seed in Seeds)
        {
            var settings = new StudySettings
            {
                SamplingInterval = samplingMs / 1000, Latency = 0.06, DelayMedian = 0.012, Loss = 0.01, Phases = 1, Seed = seed
            };
            var motion = Motions.FastMoves(seed);
            var restarts = 0;

            var alone = PredictionStudy.Run(motion, settings, () => Settings.Create(JointLimits.None)).Predicted.Rms;
            var inSession = PredictionStudy.Run(motion, settings, () => new Tracked(() => restarts++)).Predicted.Rms;

            Assert.That(restarts, Is.EqualTo(0), $"seed {seed}");
            Assert.That(inSession, Is.LessThan(1.1 * alone), $"seed {seed}; a late sample waits for the next");
        }
    }

    sealed class Tracked(Action startedAnew) : IJointPredictor
    {
        readonly JointTrack _track = new(Settings, JointLimits.None);

        public double Hold => _track.Hold;
        public double NewestTime => _track.NewestTime;

        public SampleOutcome Add(in JointSample sample)
        {
            var outcome = _track.Add(sample, out _);
            if (_track.HasStartedAnew) startedAnew();
            return outcome;
        }

        public JointPrediction At(double time) => _track.At(time);
        public void Reset() => _track.Reset();
    }
}
