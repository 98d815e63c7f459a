using System;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class BodyPredictorTests
    {
        const double Interval = 0.05;

        static BodyPredictor Fed(string name, Func<double, PoseSample> motion, int samples, double blend = 0)
        {
            var predictor = new BodyPredictor(name, PredictionLimits.Unlimited, blend);
            for (var k = 0; k < samples; k++) predictor.Add(motion(k * Interval), k * Interval + 0.1);
            return predictor;
        }

        static RigidTransform PoseOf(in PoseSample sample) => sample.Rotation.At(sample.Position.X, sample.Position.Y, sample.Position.Z);

        static void AssertPose(in RigidTransform actual, in RigidTransform expected, double tolerance)
        {
            Assert.That(actual.DistanceTo(expected), Is.LessThanOrEqualTo(tolerance), "m");
            Assert.That(actual.AngleTo(expected), Is.LessThanOrEqualTo(tolerance), "rad");
        }

        [Test]
        public void At_BeforeTheFirstSample_ReturnsTheIdentityWithKindNone()
        {
            var pose = new BodyPredictor("adaptive", PredictionLimits.Unlimited).At(1, out var kind);

            Assert.That(kind, Is.EqualTo(PredictionKind.None));
            AssertPose(pose, RigidTransform.Identity, 0);
        }

        [TestCase(2)]
        [TestCase(7)]
        [TestCase(500)]
        public void At_LinearWithConstantAngularVelocity_IsExact(int samples)
        {
            var motion = BodyMotions.Constant(new Vector3D(3, -4, 12));

            var predictor = Fed("linear", motion, samples);

            foreach (var ahead in new[] { 0, 0.03, 0.1, 0.25 })
            {
                var time = (samples - 1) * Interval + ahead;
                AssertPose(predictor.At(time), PoseOf(motion(time)), 1e-11);
            }
        }

        [TestCase("quadratic")]
        [TestCase("cubic")]
        [TestCase("quadratic-h4")]
        [TestCase("gp")]
        [TestCase("adaptive")]
        public void At_ConstantAngularVelocity_IsPredictedByEveryPredictor(string name)
        {
            var motion = BodyMotions.Constant(new Vector3D(0.3, -0.4, 1.2));

            var predictor = Fed(name, motion, 200);

            var time = 199 * Interval + 0.12;
            AssertPose(predictor.At(time), PoseOf(motion(time)), 1e-5);
        }

        // The object is seen for the first time while it moves, as on a conveyor. The noise of the samples is uniform, 0.1 mm RMS.
        [Test]
        public void At_FirstSampleDuringAMotion_IsAccurateAfterOneSecond()
        {
            double early = 0, late = 0;
            for (var seed = 0; seed < 10; seed++)
            {
                var (body, random) = (new BodyPredictor("adaptive", PredictionLimits.Unlimited), new Random(seed));
                double Noise() => 3.5e-4 * (random.NextDouble() - 0.5);
                for (var k = 0; k < 300; k++)
                {
                    var (time, shown) = (k * Interval, k * Interval + 0.13);
                    body.Add(new PoseSample(time, new Vector3D(0.3 * time + Noise(), Noise(), Noise()), UnitQuaternion.Identity), shown);
                    var error = Math.Pow(body.At(shown).X - 0.3 * shown, 2);
                    if (time > 1 && time < 3) early += error / 2;
                    if (time > 10) late += error / 5;
                }
            }

            Assert.That(Math.Sqrt(early / late), Is.LessThan(2));
        }

        [Test]
        public void At_LinearWithTwoSamples_EqualsSlerp()
        {
            var (first, second) = (BodyMotions.HandHeld(0), BodyMotions.HandHeld(Interval));
            var predictor = Fed("linear", BodyMotions.HandHeld, 2);

            var expected = UnitQuaternion.Slerp(first.Rotation, second.Rotation, 3);

            Assert.That(predictor.At(3 * Interval).AngleTo(expected.At(0, 0, 0)), Is.LessThan(1e-14));
        }

        [Test]
        public void At_Hold_IsTheNewestSample()
        {
            var predictor = Fed("hold", BodyMotions.HandHeld, 20);

            AssertPose(predictor.At(19 * Interval + 0.15), PoseOf(BodyMotions.HandHeld(19 * Interval)), 1e-14);
            AssertPose(predictor.Hold, PoseOf(BodyMotions.HandHeld(19 * Interval)), 1e-14);
        }

        [TestCase("linear")]
        [TestCase("quadratic")]
        [TestCase("adaptive")]
        public void At_ContinuousRotation_NeverJumps(string name)
        {
            var motion = BodyMotions.Constant(new Vector3D(0, 0, 9));
            var predictor = new BodyPredictor(name, PredictionLimits.Unlimited);
            var worst = 0.0;

            // 2000 samples are 143 turns.
            for (var k = 0; k < 2000; k++)
            {
                predictor.Add(motion(k * Interval), k * Interval + 0.1);
                var time = k * Interval + 0.12;
                if (k > 10) worst = Math.Max(worst, predictor.At(time).AngleTo(PoseOf(motion(time))));
            }

            Assert.That(worst, Is.LessThan(1e-3), "rad; a full turn is 6.28 rad");
        }

        // Rounding depends on the sign of the quaternion, and the mixture amplifies the difference.
        [TestCase("linear", 1e-13)]
        [TestCase("adaptive", 1e-4)]
        public void Add_QuaternionsWithReversedSigns_GiveTheSamePrediction(string name, double tolerance)
        {
            var plain = Fed(name, BodyMotions.HandHeld, 100);
            var random = new Random(3);

            var reversed = Fed(name, t => Reversed(BodyMotions.HandHeld(t), random.Next(2) == 0), 100);

            AssertPose(reversed.At(99 * Interval + 0.13), plain.At(99 * Interval + 0.13), tolerance);
        }

        static PoseSample Reversed(in PoseSample sample, bool isReversed) =>
            isReversed ? new PoseSample(sample.Time, sample.Position, BodyMotions.Negated(sample.Rotation)) : sample;

        [TestCase("hold")]
        [TestCase("cubic")]
        [TestCase("gp")]
        [TestCase("adaptive")]
        public void At_AnyTime_ReturnsAUnitQuaternion(string name)
        {
            var predictor = Fed(name, BodyMotions.WithNoise(BodyMotions.HandHeld, seed: 5), 60, blend: 0.01);

            for (var time = 0.0; time < 10; time += 0.37)
            {
                var pose = predictor.At(time);
                AssertPose(pose * pose.Inverse, RigidTransform.Identity, 1e-9);
            }
        }

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

        [Test]
        public void Reset_AfterSamples_StartsANewHistory()
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 200);
            predictor.Reset();
            Assert.That(predictor.At(1, out var kind).IsPose(), Is.True);
            Assert.That(kind, Is.EqualTo(PredictionKind.None));

            for (var k = 0; k < 60; k++) predictor.Add(BodyMotions.Turntable(k * Interval), k * Interval + 0.1);

            var fresh = Fed("adaptive", BodyMotions.Turntable, 60);
            AssertPose(predictor.At(59 * Interval + 0.1), fresh.At(59 * Interval + 0.1), 0);
        }

        [TestCase("linear")]
        [TestCase("adaptive")]
        public void At_NotANumber_ReturnsTheNewestSample(string name)
        {
            var predictor = Fed(name, BodyMotions.HandHeld, 100, blend: 0.01);

            AssertPose(predictor.At(double.NaN), predictor.Hold, 1e-12);
        }

        [Test]
        public void At_CalledTwice_ReturnsTheSamePose()
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 100, blend: 0.01);
            var before = predictor.At(99 * Interval + 0.12);

            for (var time = 0.0; time < 12; time += 0.1) predictor.At(time);

            AssertPose(predictor.At(99 * Interval + 0.12), before, 0);
        }

        [Test]
        public void At_BetweenTwoSamples_IsBetweenThem()
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 100);

            AssertPose(predictor.At(97.5 * Interval), PoseOf(BodyMotions.HandHeld(97.5 * Interval)), 2e-3);
        }

        [TestCase("linear")]
        [TestCase("adaptive")]
        public void Add_WithBlending_ContinuesFromTheDisplayedPose(string name)
        {
            var predictor = Fed(name, BodyMotions.HandHeld, 60, blend: 0.01);
            var unblended = Fed(name, BodyMotions.HandHeld, 60);
            var displayed = 59 * Interval + 0.12;
            var shown = predictor.At(displayed);

            predictor.Add(BodyMotions.HandHeld(60 * Interval), displayed);
            unblended.Add(BodyMotions.HandHeld(60 * Interval), displayed);

            Assert.That(predictor.At(displayed).DistanceTo(shown), Is.LessThan(1e-9));
            // The angles are now relative to another sample, which causes an error of second order.
            Assert.That(predictor.At(displayed).AngleTo(shown), Is.LessThan(1e-3));
            Assert.That(predictor.At(displayed + 0.1).DistanceTo(unblended.At(displayed + 0.1)), Is.LessThan(1e-5), "ten time constants later");
        }

        [Test]
        public void Add_ObjectMovedElsewhere_IsNotBlended()
        {
            var predictor = Fed("adaptive", BodyMotions.HandHeld, 60, blend: 0.01);
            var moved = BodyMotions.HandHeld(60 * Interval);

            predictor.Add(new PoseSample(moved.Time, moved.Position + new Vector3D(50, 0, 0), moved.Rotation), 59 * Interval + 0.12);

            Assert.That(predictor.At(59 * Interval + 0.12).X, Is.GreaterThan(49));
        }

        // The workpiece reappears half an interval before the sample with index 100.
        [Test]
        public void Add_ObjectMovedElsewhere_IsHeldThereUntilTheNextSample()
        {
            PoseSample Motion(double t) =>
                new PoseSample(t, BodyMotions.Reappearing(t + 2 / 0.3 - 99.5 * Interval).Position, UnitQuaternion.Identity);
            var predictor = Fed("adaptive", Motion, 101);

            Assert.That(predictor.At(100 * Interval + 0.1, out var kind).X, Is.EqualTo(0.3 * 0.5 * Interval).Within(1e-9));
            Assert.That(kind, Is.EqualTo(PredictionKind.Held));

            predictor.Add(Motion(101 * Interval), 100 * Interval + 0.1);

            Assert.That(predictor.At(101 * Interval + 0.1, out kind).X, Is.EqualTo(0.3 * (1.5 * Interval + 0.1)).Within(1e-6));
            Assert.That(kind, Is.EqualTo(PredictionKind.Predicted));
        }

        // The sizes and intervals of jumps that an object cannot make by moving.
        [TestCase(0.02, 0.05, 0)]
        [TestCase(0.05, 0.12, 0)]
        [TestCase(0.1, 0.5, 0)]
        [TestCase(0.02, 0, 0.3)]
        [TestCase(0.05, 0, 0.5)]
        [TestCase(0.1, 0, 1.5)]
        public void Add_ObjectJumps_IsHeldAtTheNewPoseUntilTheNextSample(double interval, double metres, double radians)
        {
            PoseSample Motion(int i) => new PoseSample(
                i * interval, new Vector3D(i >= 100 ? metres : 0, 0.1, 0), UnitQuaternion.Exp(new Vector3D(0, 0, i >= 100 ? radians : 0)));
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i <= 100; i++) predictor.Add(Motion(i), (i - 1) * interval + 0.1);

            AssertPose(predictor.At(100 * interval + 0.1, out var kind), PoseOf(Motion(100)), 1e-9);
            Assert.That(kind, Is.EqualTo(PredictionKind.Held));

            predictor.Add(Motion(101), 100 * interval + 0.1);

            AssertPose(predictor.At(101 * interval + 0.1, out kind), PoseOf(Motion(101)), 1e-9);
            Assert.That(kind, Is.EqualTo(PredictionKind.Predicted));
        }

        // One of a hundred samples is wrong, as of a marker that a camera sees at a flat angle.
        [TestCase(0.02)]
        [TestCase(0.05)]
        public void At_OutliersOfATracker_AreNotPredictedAsAMotion(double interval)
        {
            var random = new Random(5);
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            var furthest = 0.0;
            for (var i = 0; i < 1000; i++)
            {
                var outlier = i > 50 && i % 100 == 0 ? 0.1 + 0.1 * random.NextDouble() : 0;
                predictor.Add(new PoseSample(i * interval, new Vector3D(outlier + 3e-4 * random.NextDouble(), 0, 0), UnitQuaternion.Identity), (i - 1) * interval + 0.1);
                if (i > 20) furthest = Math.Max(furthest, Math.Abs(predictor.At(i * interval + 0.1).X));
            }

            Assert.That(furthest, Is.LessThan(0.21), "seed 5; not beyond the largest outlier");
        }

        // A planar marker on a belt: a tracker confuses two rotations now and then, but its position is right.
        [Test]
        public void Add_OnlyTheRotationJumps_PositionIsPredictedAndThePoseIsNotCurrent()
        {
            PoseSample Motion(int i) => new PoseSample(
                i * Interval, new Vector3D(0.5 * i * Interval, 0, 0), UnitQuaternion.Exp(new Vector3D(0, 0, i == 100 ? 0.6 : 0)));
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i <= 100; i++) predictor.Add(Motion(i), (i - 1) * Interval + 0.1);

            var pose = predictor.At(100 * Interval + 0.1, out var kind);

            Assert.That(pose.X, Is.EqualTo(0.5 * (100 * Interval + 0.1)).Within(1e-6));
            Assert.That(UnitQuaternion.Of(pose).Log().Z, Is.EqualTo(0.6).Within(1e-9));
            Assert.That(kind, Is.EqualTo(PredictionKind.Held));
        }

        // The sample before the jump arrives after the jump. It must not make the jump a motion.
        [Test]
        public void Add_SampleFromBeforeTheJumpArrivesLater_IsNotPartOfTheNewMotion()
        {
            PoseSample Motion(int i) => new PoseSample(i * Interval, new Vector3D(0.3 * i * Interval - (i >= 100 ? 1 : 0), 0, 0), UnitQuaternion.Identity);
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i <= 98; i++) predictor.Add(Motion(i), (i - 1) * Interval + 0.1);

            foreach (var i in new[] { 100, 99, 101, 102, 103, 104, 105, 106, 107, 108, 109, 110 })
            {
                predictor.Add(Motion(i), (i - 1) * Interval + 0.1);
                if (i >= 101) Assert.That(predictor.At(i * Interval + 0.1).X, Is.EqualTo(0.3 * (i * Interval + 0.1) - 1).Within(0.002), $"sample {i}");
            }
        }

        // On a belt at 2.2 m/s, the speed alone exceeds the limit of a jump.
        [Test]
        public void Add_FastObjectJumps_IsHeldForOneSample()
        {
            PoseSample Motion(int i) => new PoseSample(i * Interval, new Vector3D(2.2 * i * Interval - (i >= 100 ? 2 : 0), 0, 0), UnitQuaternion.Identity);
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i <= 101; i++) predictor.Add(Motion(i), (i - 1) * Interval + 0.1);

            Assert.That(predictor.At(101 * Interval + 0.1, out var kind).X, Is.EqualTo(2.2 * (101 * Interval + 0.1) - 2).Within(1e-6));
            Assert.That(kind, Is.EqualTo(PredictionKind.Predicted));
        }

        // A delta robot moves a part by 300 mm in 0.2 s, with up to 43 m/s².
        [Test]
        public void At_MovesOfADeltaRobot_AreNotHeld()
        {
            double Smooth(double u) => u <= 0 ? 0 : u >= 1 ? 1 : u * u * u * (10 + u * (6 * u - 15));
            PoseSample Motion(double t)
            {
                var (move, since) = ((int)(t / 1.2), t % 1.2);
                var share = move % 2 == 0 ? Smooth(since / 0.2) : 1 - Smooth(since / 0.2);
                return new PoseSample(t, new Vector3D(0.3 * share, 0, 0), UnitQuaternion.Identity);
            }
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i < 400; i++)
            {
                predictor.Add(Motion(i * Interval), (i - 1) * Interval + 0.1);
                predictor.At(i * Interval + 0.1, out var kind);
                if (i > 1) Assert.That(kind, Is.EqualTo(PredictionKind.Predicted), $"at {i * Interval} s");
            }
        }

        // Two wrong samples in a row that differ from each other, while the object moves.
        [Test]
        public void At_TwoDifferentOutliersOfAMovingObject_AreNotPredictedAsAMotion()
        {
            PoseSample Motion(int i) => new PoseSample(
                i * Interval, new Vector3D(0.4 * Math.Sin(i * Interval) + (i == 100 ? 0.3 : i == 101 ? -0.4 : 0), 0, 0), UnitQuaternion.Identity);
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i <= 104; i++)
            {
                predictor.Add(Motion(i), (i - 1) * Interval + 0.1);
                var expected = i == 100 || i == 101 ? Motion(i).Position.X : 0.4 * Math.Sin(i * Interval + 0.1);
                if (i >= 99) Assert.That(predictor.At(i * Interval + 0.1).X, Is.EqualTo(expected).Within(i < 102 ? 0.02 : 0.05), $"sample {i}");
            }
        }

        // A person shakes the object by 12 cm two and a half times a second: its accelerations reach 30 m/s² and 115 rad/s².
        [Test]
        public void At_ShakenObject_IsPredicted()
        {
            PoseSample Motion(double t) => new PoseSample(
                t, new Vector3D(0.12 * Math.Sin(15.7 * t), 0.08 * Math.Sin(19.5 * t), 0), UnitQuaternion.Exp(new Vector3D(0, 0, 0.6 * Math.Sin(13.8 * t))));
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            var held = 0;
            for (var i = 0; i < 400; i++)
            {
                predictor.Add(Motion(i * Interval), (i - 1) * Interval + 0.1);
                predictor.At(i * Interval + 0.1, out var kind);
                if (i > 20 && kind == PredictionKind.Held) held++;
            }

            Assert.That(held, Is.LessThan(12), "3 % of the samples");
        }

        // A car at 25 m/s that passes a camera, and a test flight: fast, but not moved elsewhere.
        [TestCase(25, 0)]
        [TestCase(0, 15)]
        public void Add_FastObject_IsPredicted(double speed, double acceleration)
        {
            Vector3D Position(double t) => new Vector3D(speed * t + acceleration * t * t / 2, 0, 0);

            var predictor = Fed("adaptive", t => new PoseSample(t, Position(t), UnitQuaternion.Identity), 60);

            var time = 59 * Interval + 0.1;
            Assert.That(predictor.At(time, out var kind).X, Is.EqualTo(Position(time).X).Within(0.1));
            Assert.That(kind, Is.EqualTo(PredictionKind.Predicted));
        }

        [TestCase(double.NaN, 0, 0)]
        [TestCase(0, double.NaN, 0)]
        [TestCase(0, double.PositiveInfinity, 0)]
        [TestCase(0, 0, double.NaN)]
        public void PoseSample_NotFinite_Throws(double time, double x, double order) =>
            Assert.That(() => new PoseSample(time, new Vector3D(x, 0, 0), UnitQuaternion.Identity, order), Throws.ArgumentException);

        [Test]
        public void PoseSample_DefaultRotation_Throws() =>
            Assert.That(() => new PoseSample(0, default, default), Throws.ArgumentException);
    }
}
