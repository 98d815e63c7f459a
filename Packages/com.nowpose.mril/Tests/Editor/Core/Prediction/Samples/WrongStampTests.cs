using System;
using Nowpose.Prediction;
using NUnit.Framework;
using static Nowpose.Tests.Core.Prediction.Samples.ArrivalOrderTests;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    /// <summary>Checks which sample is discarded if a single stamp is wrong.</summary>
    public class WrongStampTests
    {
        [TestCase(0.1)]
        [TestCase(0.3)]
        [TestCase(0.9)]
        public void Add_OneStampInTheFuture_OnlyThisSampleIsDiscarded(double seconds)
        {
            JointPredictor joint = FedJoint(), expected = FedJoint();
            joint.Add(new JointSample((Newest + 1) * Interval + seconds, PositionAt((Newest + 1) * Interval)));

            for (var i = 2; i <= 8; i++) joint.Add(Sample((Newest + i) * Interval));
            for (var i = 2; i <= 8; i++) expected.Add(Sample((Newest + i) * Interval));

            Assert.That(joint.Restarts, Is.Zero);
            Assert.That(joint.NewestTime, Is.EqualTo(expected.NewestTime));
            Assert.That(joint.At(2.3).Position, Is.EqualTo(expected.At(2.3).Position).Within(1e-9));
        }

        [TestCase(1.1)]
        [TestCase(1.5)]
        [TestCase(1.9)]
        [TestCase(2)]
        [TestCase(2.5)]
        public void Add_OneStampInTheFutureByFewIntervals_IsWrongFromTheNextNewerSampleOn(double intervals)
        {
            var joint = FedJoint();
            joint.Add(new JointSample((Newest + 1 + intervals) * Interval, PositionAt((Newest + 1) * Interval)));
            for (var i = 2; i <= 1 + intervals; i++) joint.Add(Sample((Newest + i) * Interval));
            Assert.That(joint.IsNewestStampWrong, Is.False);

            joint.Add(Sample((Newest + 2 + Math.Floor(intervals)) * Interval));

            Assert.That(joint.IsNewestStampWrong, Is.True);
        }

        // The order alone does not show which of the two samples has the wrong stamp.
        [TestCase(1.2)]
        [TestCase(1.5)]
        [TestCase(1.8)]
        public void Add_OneStampInThePast_TheSampleBeforeItIsKept(double intervals)
        {
            var joint = FedJoint();
            joint.Add((Newest + 1 - intervals) * Interval, PositionAt((Newest + 1) * Interval));

            joint.Add(Sample((Newest + 2) * Interval));

            Assert.That(joint.IsNewestStampWrong, Is.False);
        }

        // At rest, positions with noise do not show the order of the samples.
        [Test]
        public void Add_SamplesAtRestWithNoiseAreOvertaken_AreHardlyEverWrong()
        {
            var random = new Random(1);
            var wrong = 0;
            for (var run = 0; run < 20; run++)
            {
                var joint = Predictors.Create("adaptive", PredictionLimits.Unlimited);
                for (var k = 0; k < 400; k += 2)
                    foreach (var at in random.NextDouble() < 0.2 ? new[] { k + 1, k } : new[] { k, k + 1 })
                    {
                        var noise = random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5;
                        joint.Add(new JointSample(at * Interval, 1 + 1e-3 * noise));
                        if (joint.IsNewestStampWrong) wrong++;
                    }
            }

            Assert.That(wrong, Is.LessThanOrEqualTo(2), "of about 800");
        }

        // A source whose clock has a resolution of two intervals.
        [Test]
        public void Add_TwoSamplesWithEachStamp_TheSecondIsDropped()
        {
            var joint = FedJoint();
            for (var i = 2; i < 50; i++)
            {
                var reason = joint.Add(new JointSample((Newest + i / 2 * 2) * Interval, PositionAt((Newest + i) * Interval)));
                Assert.That(reason, Is.EqualTo(i % 2 == 0 ? DropReason.None : DropReason.DuplicateSample), "sample " + i);
                Assert.That(joint.IsNewestStampWrong, Is.False, "sample " + i);
            }
        }
    }
}
