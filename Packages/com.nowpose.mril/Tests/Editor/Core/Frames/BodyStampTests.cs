using System;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using NUnit.Framework;
using static Nowpose.Tests.Core.Frames.FedBody;

namespace Nowpose.Tests.Core.Frames
{
    public class BodyStampTests
    {
        [TestCase("linear", 1e-12)]
        [TestCase("quadratic", 1e-4)]
        [TestCase("adaptive", 2e-3)]
        public void Add_LateSample_GivesTheSameResultAsInOrder(string name, double tolerance)
        {
            var inOrder = Fed(name, BodyMotions.HandHeld, 42);
            var predictor = Fed(name, BodyMotions.HandHeld, 39);

            Assert.That(predictor.Add(BodyMotions.HandHeld(40 * Interval)), Is.EqualTo(DropReason.None));
            Assert.That(predictor.Add(BodyMotions.HandHeld(39 * Interval)), Is.EqualTo(DropReason.None));
            Assert.That(predictor.Add(BodyMotions.HandHeld(41 * Interval)), Is.EqualTo(DropReason.None));

            AssertPose(predictor.At(41 * Interval + 0.12), inOrder.At(41 * Interval + 0.12), tolerance);
        }

        [TestCase("linear", 0)]
        [TestCase("adaptive", 0)]
        [TestCase("adaptive", 3)]
        public void Add_RepeatedSample_ChangesNothing(string name, int age)
        {
            var predictor = Fed(name, BodyMotions.HandHeld, 40);
            var before = predictor.At(39 * Interval + 0.12);

            for (var i = 0; i < 10; i++)
                Assert.That(predictor.Add(BodyMotions.HandHeld((39 - age) * Interval)), Is.EqualTo(DropReason.DuplicateSample));

            AssertPose(predictor.At(39 * Interval + 0.12), before, 0);
        }

        [Test]
        public void Add_ClockWentBack_RestartsTheWholePose()
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 200);

            for (var k = 0; k < 6 && predictor.Restarts == 0; k++)
            {
                var sample = BodyMotions.HandHeld(20 + k * Interval);
                predictor.Add(new PoseSample(2 + k * Interval, sample.Position, sample.Rotation));
            }

            Assert.That(predictor.Restarts, Is.GreaterThan(0));
            Assert.That(predictor.NewestTime, Is.LessThan(3));
            Assert.That(predictor.At(2.2, out var kind).IsPose(), Is.True);
            Assert.That(kind, Is.Not.EqualTo(PredictionKind.None));
        }

        [TestCase(0.09)]
        [TestCase(0.2)]
        [TestCase(0.9)]
        public void Add_OneStampInTheFuture_OnlyThisSampleIsDiscarded(double seconds)
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 200);
            for (var k = 200; k < 212; k++)
            {
                var sample = BodyMotions.HandHeld(k * Interval);
                predictor.Add(new PoseSample(k * Interval + (k == 200 ? seconds : 0), sample.Position, sample.Rotation));
            }

            var truth = BodyMotions.HandHeld(211 * Interval);
            Assert.That((predictor.Restarts, predictor.NewestTime), Is.EqualTo((0, 211 * Interval)));
            AssertPose(predictor.Hold, PoseOf(truth), 1e-9);
            AssertPose(predictor.PoseAt(206.5 * Interval, out var origin), PoseOf(BodyMotions.HandHeld(206.5 * Interval)), 0.01);
            Assert.That(origin, Is.EqualTo(PoseOrigin.Measured));
            AssertPose(predictor.At(212 * Interval), PoseOf(BodyMotions.HandHeld(212 * Interval)), 0.01);
        }

        // The samples that waited until their number proved that the clock went back are the start of the new history.
        [Test]
        public void Add_ClockWentBack_UsesTheWaitingSamples()
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 200);
            for (var k = 0; predictor.Restarts == 0; k++)
            {
                var sample = BodyMotions.HandHeld(20 + k * Interval);
                predictor.Add(new PoseSample(2 + k * Interval, sample.Position, sample.Rotation));
            }

            var pose = predictor.At(predictor.NewestTime - 0.99 * Interval, out var kind);

            Assert.That(kind, Is.EqualTo(PredictionKind.Interpolated));
            AssertPose(pose, PoseOf(BodyMotions.HandHeld(18 + predictor.NewestTime - 0.99 * Interval)), 1e-3);
        }

        // The clock goes back by two sampling intervals, so stamps that are already known are repeated with other poses.
        [Test]
        public void Add_ClockWentBackByWholeIntervals_IsRecognisedInEveryCoordinate([Range(0, 5)] int coordinate)
        {
            // The swing is fastest at sample 114.
            var predictor = Fed("adaptive", t => Swing(coordinate, t, t), 114);

            for (var k = 114; k < 116; k++) predictor.Add(Swing(coordinate, k * Interval, (k - 2) * Interval), k * Interval);

            Assert.That(predictor.Restarts, Is.EqualTo(1));
        }

        // Wrong stamps are recognised by the smoothness of the motion, in whichever coordinate it is.
        [Test]
        public void At_StampsWithErrors_IsAlmostAsAccurateAsWithoutErrorsInEveryCoordinate([Range(0, 5)] int coordinate)
        {
            var random = new Random(8);
            double exact = 0, scattered = 0;
            var (reference, predictor) = (new BodyPredictor("adaptive", PredictionLimits.Unlimited), new BodyPredictor("adaptive", PredictionLimits.Unlimited));
            for (var k = 0; k < 400; k++)
            {
                var (time, shown) = (k * Interval, k * Interval + 0.1);
                reference.Add(Swing(coordinate, time, time), shown);
                predictor.Add(Swing(coordinate, time, time + 0.01 * (random.NextDouble() - 0.5)), shown);
                if (k < 100) continue;
                exact += Square(reference.At(shown), Swing(coordinate, shown, shown));
                scattered += Square(predictor.At(shown), Swing(coordinate, shown, shown));
            }

            // Without the correction, the error is 12 times as large.
            Assert.That(Math.Sqrt(scattered / exact), Is.LessThan(3));
        }

        // Returns a pose that moves in one of the six coordinates only.
        static PoseSample Swing(int coordinate, double time, double stamp)
        {
            double Of(int c) => c == coordinate ? 0.3 * Math.Sin(2.2 * time) : 0;
            return new PoseSample(stamp, new Vector3D(Of(0), Of(1), Of(2)), UnitQuaternion.Exp(new Vector3D(Of(3), Of(4), Of(5))), stamp);
        }

        static double Square(in RigidTransform pose, in PoseSample truth) =>
            Math.Pow(pose.DistanceTo(PoseOf(truth)), 2) + Math.Pow(pose.AngleTo(PoseOf(truth)), 2);
    }
}
