using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;
using static Nowpose.Tests.Core.Frames.FedBody;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>Checks the poses of an object at times before the samples of its predictor, from which grips are decided.</summary>
    public class BodyPastTests
    {
        [TestCase("linear", 0.01)]
        [TestCase("hold", 0.05)]
        [TestCase("adaptive", 0.004)]
        public void PoseAt_TimeBeforeTheSamplesOfThePredictor_IsMeasuredForMoreThanASecond(string name, double interval)
        {
            var predictor = new BodyPredictor(name, new PredictionLimits());
            for (var k = 0; k * interval < 3; k++) predictor.Add(BodyMotions.HandHeld(k * interval));

            for (var t = 1.8; t < 2.9; t += 0.013)
            {
                AssertPose(predictor.PoseAt(t, out var origin), PoseOf(BodyMotions.HandHeld(t)), 0.01);
                Assert.That(origin, Is.EqualTo(PoseOrigin.Measured), $"{t} s");
            }
            predictor.PoseAt(-1, out var before);
            Assert.That(before, Is.EqualTo(PoseOrigin.None));
        }

        // The sample with the wrong stamp must not hide those that follow.
        [TestCase(0.09)]
        [TestCase(0.3)]
        [TestCase(0.9)]
        public void Add_OneStampInTheFuture_ThePastIsThatOfTheOtherSamples(double future)
        {
            var predictor = new BodyPredictor("linear", new PredictionLimits());
            for (var k = 0; k < 60; k++)
            {
                var sample = BodyMotions.HandHeld(k * Interval);
                predictor.Add(new PoseSample(sample.Time + (k == 40 ? future : 0), sample.Position, sample.Rotation));
            }

            for (var t = 2.15; t < 2.9; t += 0.013)
            {
                AssertPose(predictor.PoseAt(t, out var origin), PoseOf(BodyMotions.HandHeld(t)), 0.01);
                Assert.That(origin, Is.EqualTo(PoseOrigin.Measured), $"{t} s");
            }
        }
    }
}
