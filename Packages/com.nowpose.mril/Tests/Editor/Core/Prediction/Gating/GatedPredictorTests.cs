using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Gating;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class GatedPredictorTests
    {
        const double Interval = 0.05;

        Oracle _candidate;
        GatedPredictor _gate;

        [SetUp]
        public void MakeGate()
        {
            _candidate = new Oracle();
            _gate = new GatedPredictor(_candidate, new HoldPredictor(PredictionLimits.Unlimited), 0.3);
        }

        [Test]
        public void At_CandidateThatIsRight_SpeaksAfterADozenScores()
        {
            Feed(0, 10);
            Assert.That(_gate.IsOpen, Is.False);

            Feed(10, 30);

            Assert.That(_gate.IsOpen);
            var t = 29 * Interval + 0.1;
            Assert.That(_gate.At(t).Position, Is.EqualTo(Truth(t)).Within(1e-9));
        }

        [Test]
        public void At_CandidateThatIsWrong_NeverSpeaks()
        {
            _candidate.Error = 0.5;
            for (var k = 0; k < 200; k++)
            {
                Feed(k, k + 1);

                Assert.That(_gate.At(k * Interval + 0.1).Position, Is.EqualTo(_gate.Hold));
            }
        }

        [Test]
        public void At_CandidateThatBecomesWrong_IsSilencedWithinASecond()
        {
            Feed(0, 100);
            Assert.That(_gate.IsOpen);

            _candidate.Error = 0.5;
            Feed(100, 120);

            Assert.That(_gate.IsOpen, Is.False);
        }

        [Test]
        public void At_CandidateWithoutAWord_TheOtherSpeaks()
        {
            Feed(0, 100);
            _candidate.IsSilent = true;

            Assert.That(_gate.At(99 * Interval + 0.1).Position, Is.EqualTo(_gate.Hold));
        }

        [Test]
        public void At_Rest_ProvesNothing()
        {
            for (var k = 0; k < 200; k++) _gate.Add(new JointSample(k * Interval, 3));

            Assert.That(_gate.IsOpen, Is.False);
        }

        [Test]
        public void Reset_ForgetsTheRecord()
        {
            Feed(0, 100);

            _gate.Reset();

            Assert.That(_gate.IsOpen, Is.False);
            Assert.That(_gate.At(0).Kind, Is.EqualTo(PredictionKind.None));
        }

        static double Truth(double t) => Math.Sin(3 * t);

        void Feed(int from, int to)
        {
            for (var k = from; k < to; k++) _gate.Add(new JointSample(k * Interval, Truth(k * Interval)));
        }

        sealed class Oracle : IJointPredictor
        {
            public double Error { get; set; }
            public bool IsSilent { get; set; }
            public double Hold => 0;
            public double NewestTime => 0;

            public SampleOutcome Add(in JointSample sample) => SampleOutcome.Accepted;

            public JointPrediction At(double time) =>
                IsSilent ? default : new JointPrediction(Truth(time) + Error, PredictionKind.Predicted);

            public void Reset() { }
        }
    }
}
