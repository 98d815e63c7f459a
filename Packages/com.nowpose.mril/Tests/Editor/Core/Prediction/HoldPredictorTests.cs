using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class HoldPredictorTests
    {
        [Test]
        public void At_AnyTime_IsTheNewestSample()
        {
            var predictor = new HoldPredictor(new PredictionLimits());
            predictor.Add(new JointSample(1, 10));
            predictor.Add(new JointSample(2, 20));

            foreach (var time in new[] { 0.0, 2, 2.1, 99 })
            {
                Assert.That(predictor.At(time).Position, Is.EqualTo(20));
                Assert.That(predictor.At(time).Kind, Is.EqualTo(PredictionKind.Held));
            }
            Assert.That(predictor.NewestTime, Is.EqualTo(2));
        }

        [Test]
        public void Add_OlderSample_ChangesNothing()
        {
            var predictor = new HoldPredictor(new PredictionLimits());
            predictor.Add(new JointSample(2, 20));

            Assert.That(predictor.Add(new JointSample(1, 10)), Is.EqualTo(SampleOutcome.TooOld));
            Assert.That(predictor.Add(new JointSample(2, 30)), Is.EqualTo(SampleOutcome.Duplicate));
            Assert.That(predictor.Hold, Is.EqualTo(20));
        }

        [Test]
        public void At_BeyondTheJointLimits_StopsAtThem()
        {
            var predictor = new HoldPredictor(new PredictionLimits(lower: 0, upper: 5));
            predictor.Add(new JointSample(2, 20));

            Assert.That(predictor.At(2).Position, Is.EqualTo(5));
        }

        [Test]
        public void Reset_AfterSamples_IsNone()
        {
            var predictor = new HoldPredictor(new PredictionLimits());
            Assert.That(predictor.At(2).Kind, Is.EqualTo(PredictionKind.None));
            predictor.Add(new JointSample(2, 20));

            predictor.Reset();

            Assert.That(predictor.At(2).Kind, Is.EqualTo(PredictionKind.None));
            Assert.That(predictor.Hold, Is.EqualTo(0));
        }
    }
}
