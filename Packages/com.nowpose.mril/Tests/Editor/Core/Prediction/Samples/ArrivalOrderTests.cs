using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Prediction;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    public class ArrivalOrderTests
    {
        internal const double Interval = 0.02;
        internal const int Newest = 100;

        internal static double PositionAt(double time) => Math.Sin(2 * time);

        internal static JointSample Sample(double time) => new JointSample(time, PositionAt(time));

        static JointPredictor NewJoint() => TestPredictors.Polynomial(2, 4);

        // Returns a joint with samples of two seconds, which were added in order.
        internal static JointPredictor FedJoint()
        {
            var joint = NewJoint();
            for (var i = 0; i <= Newest; i++) joint.Add(Sample(i * Interval));
            return joint;
        }

        [TestCase(1, 3, 2, 4)]
        [TestCase(4, 1, 2, 3, 5)]
        [TestCase(5, 1, 2, 3, 4, 6)]
        [TestCase(4, 3, 2, 1, 5)]
        [TestCase(6, 2, 5, 1, 4, 3, 7)]
        public void Add_SamplesOutOfOrder_GivesTheSamePredictionAsInOrder(params int[] order)
        {
            JointPredictor shuffled = FedJoint(), inOrder = FedJoint();

            foreach (var i in order) shuffled.Add(Sample((Newest + i) * Interval));
            foreach (var i in order.OrderBy(i => i)) inOrder.Add(Sample((Newest + i) * Interval));

            var time = (Newest + order.Max() + 4) * Interval;
            Assert.That(shuffled.At(time).Position, Is.EqualTo(inOrder.At(time).Position).Within(1e-12));
            Assert.That(shuffled.NewestTime, Is.EqualTo(inOrder.NewestTime));
            Assert.That(shuffled.Restarts, Is.EqualTo(0));
        }

        [TestCase(3600, 2)]
        [TestCase(1, 2)]
        [TestCase(0.45, 2)]
        [TestCase(0.13, 2)]
        [TestCase(0.12, 2, TestName = "Add_ClockWentBackBySixIntervals_IsFollowed")]
        [TestCase(0.06, 2, TestName = "Add_ClockWentBackByThreeIntervals_IsFollowed")]
        [TestCase(0.04, 2, TestName = "Add_ClockWentBackByTwoIntervals_IsFollowed")]
        public void Add_ClockWentBack_IsFollowedWithinAFewSamples(double seconds, int samples)
        {
            var joint = FedJoint();
            var needed = 0;

            // The positions continue; only the stamps jump back.
            for (var i = 1; joint.Restarts == 0 && i < 10; i++, needed++)
                joint.Add(new JointSample((Newest + i) * Interval - seconds, PositionAt((Newest + i) * Interval)));

            Assert.That(needed, Is.EqualTo(samples));
            var now = (Newest + needed) * Interval;
            Assert.That(joint.NewestTime, Is.EqualTo(now - seconds));
            Assert.That(joint.Hold, Is.EqualTo(PositionAt(now)));
            Assert.That(
                joint.At(now - seconds + Interval).Position, Is.EqualTo(PositionAt(now + Interval)).Within(2e-3), "a straight line through two");
        }

        [TestCase(3600, 2)]
        [TestCase(0.45, 2)]
        [TestCase(0.13, 5)]
        public void Add_ClockWentBackWhileTheJointRests_IsFollowedWithinAFewSamples(double seconds, int samples)
        {
            var joint = NewJoint();
            for (var i = 0; i <= Newest; i++) joint.Add(new JointSample(i * Interval, 0.5));
            var needed = 0;

            for (var i = 1; joint.Restarts == 0 && i < 10; i++, needed++)
                joint.Add(new JointSample((Newest + i) * Interval - seconds, 0.5));

            Assert.That(needed, Is.EqualTo(samples));
        }

        [Test]
        public void Add_ClockWentBackAfterAnOvertakenSample_IsFollowed()
        {
            var joint = FedJoint();
            joint.Add(Sample((Newest - 0.5) * Interval));

            joint.Add(new JointSample(Interval - 50, 0.1));
            joint.Add(new JointSample(2 * Interval - 50, 0.2));

            Assert.That(joint.Restarts, Is.EqualTo(1));
            Assert.That(joint.NewestTime, Is.EqualTo(2 * Interval - 50));
        }

        [Test]
        public void Add_SamplesRepeated_AreDuplicates()
        {
            var joint = FedJoint();
            var before = joint.At((Newest + 5) * Interval).Position;

            for (var i = Newest - 60; i <= Newest; i++)
                Assert.That(joint.Add(Sample(i * Interval)), Is.EqualTo(DropReason.DuplicateSample), "sample " + i);

            Assert.That(joint.At((Newest + 5) * Interval).Position, Is.EqualTo(before));
        }

        [Test]
        public void Add_PendingSampleRepeated_IsADuplicate()
        {
            var joint = NewJoint();
            joint.Add(Sample(1));
            joint.Add(Sample(0.9));

            Assert.That(joint.Add(Sample(0.9)), Is.EqualTo(DropReason.DuplicateSample));
        }

        // At rest after a move; the overtaken samples differ by one encoder count.
        [Test]
        public void Add_OvertakenSampleAtRest_DoesNotRestart()
        {
            var joint = NewJoint();
            for (var i = 0; i < 50; i++) joint.Add(i * Interval, Math.Min(0.5, 0.02 * i));
            for (var i = 50; i <= Newest; i++) joint.Add(i * Interval, 0.5);

            joint.Add((Newest + 3) * Interval, 0.5);
            foreach (var i in new[] { 1, 2 })
                Assert.That(joint.Add((Newest + i) * Interval, 0.5001), Is.EqualTo(DropReason.None), "sample " + i);

            Assert.That(joint.Restarts, Is.EqualTo(0));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Add_OvertakenPairsOfNoisySamplesAtRest_RarelyRestart(bool isEndless)
        {
            const int pairs = 2000;
            var random = new Random(77);
            var joint = TestPredictors.Polynomial(2, 4, new PredictionLimits(isEndless: isEndless));
            // Noise around π wraps to −π.
            double Position()
            {
                var position = (isEndless ? Math.PI : 0) + 1e-3 * (random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5);
                return isEndless ? Math.IEEERemainder(position, 2 * Math.PI) : position;
            }

            for (var i = 0; i < pairs; i++)
                foreach (var k in new[] { 0, 1, 2, 5, 3, 4 }) joint.Add((6 * i + k) * Interval, Position());

            Assert.That(joint.Restarts, Is.LessThan(0.005 * pairs), "seed 77");
        }

        [Test]
        public void Add_SameStampWithAnotherPosition_IsDropped()
        {
            var joint = FedJoint();
            var inOrder = FedJoint();

            Assert.That(joint.Add((Newest - 1) * Interval, PositionAt((Newest - 1) * Interval) + 1e-6), Is.EqualTo(DropReason.DuplicateSample));
            joint.Add(Sample((Newest + 1) * Interval));

            inOrder.Add(Sample((Newest + 1) * Interval));
            Assert.That(joint.At(2.1).Position, Is.EqualTo(inOrder.At(2.1).Position));
        }

        [Test]
        public void Add_ExtremelyLateSample_KeepsTheHistory()
        {
            var joint = FedJoint();
            var inOrder = FedJoint();

            joint.Add((Newest - 0.5) * Interval, 1e60);
            joint.Add(Sample((Newest + 1) * Interval));

            inOrder.Add(Sample((Newest + 1) * Interval));
            Assert.That(joint.At(2.1).Position, Is.EqualTo(inOrder.At(2.1).Position));
        }

        [Test]
        public void Add_SampleOlderThanTheHistory_IsDroppedAsLate()
        {
            var joint = FedJoint();
            var inOrder = FedJoint();

            Assert.That(joint.Add(Sample(-20)), Is.EqualTo(DropReason.LateSample));
            Assert.That(joint.Add(Sample((Newest + 1) * Interval)), Is.EqualTo(DropReason.None));

            inOrder.Add(Sample((Newest + 1) * Interval));
            Assert.That(joint.At(2.1).Position, Is.EqualTo(inOrder.At(2.1).Position));
        }

        // The sample that follows the newest one has a stamp that is early by 1.7 intervals.
        [Test]
        public void Add_LateSampleContradictsItsNeighbours_IsDropped()
        {
            var joint = FedJoint();
            var inOrder = FedJoint();

            Assert.That(joint.Add((Newest - 0.7) * Interval, PositionAt((Newest + 1) * Interval)), Is.EqualTo(DropReason.LateSample));
            joint.Add(Sample((Newest + 2) * Interval));

            inOrder.Add(Sample((Newest + 2) * Interval));
            Assert.That(joint.At(2.15).Position, Is.EqualTo(inOrder.At(2.15).Position));
        }

        [Test]
        public void Add_OvertakenSample_WaitsForTheNextSample()
        {
            var joint = TestPredictors.Polynomial(1, 1);
            joint.Add(0, 0);
            joint.Add(2, 2);

            Assert.That(joint.Add(1, 1.5), Is.EqualTo(DropReason.None));
            Assert.That(joint.At(3).Position, Is.EqualTo(3).Within(1e-12), "the sample is not dropped, because the clock may have gone back");
            Assert.That(joint.Hold, Is.EqualTo(2));
        }

        [Test]
        public void Add_TwoSourcesOneLagging_DoesNotRestart()
        {
            var joint = FedJoint();
            for (var i = 1; i <= 500; i++)
            {
                joint.Add(Sample((Newest + i) * Interval));
                joint.Add(Sample((Newest + i) * Interval - 0.33 * Interval - 0.4));
                Assert.That(joint.Restarts, Is.EqualTo(0), "sample " + i);
            }
        }

        [TestCase(0.02)]
        [TestCase(0.01)]
        public void Add_DelaysOfAWirelessNetwork_DoNotRestartAndKeepAllSamples(double interval)
        {
            const int seed = 41;
            var random = new Random(seed);
            var joint = NewJoint();
            var arrivals = new List<(double At, double Stamp)>();
            for (var i = 0; i < 10_000; i++)
            {
                var normal = random.NextNormal();
                arrivals.Add((i * interval + Math.Min(0.120, 0.012 * Math.Exp(normal)), i * interval));
            }
            var late = 0;

            foreach (var (_, stamp) in arrivals.OrderBy(a => a.At))
            {
                if (stamp < joint.NewestTime) late++;
                joint.Add(Sample(stamp));
            }

            Assert.That(late, Is.GreaterThan(500), "samples overtake each other, seed " + seed);
            Assert.That(joint.Restarts, Is.EqualTo(0), "seed " + seed);
        }
    }
}
