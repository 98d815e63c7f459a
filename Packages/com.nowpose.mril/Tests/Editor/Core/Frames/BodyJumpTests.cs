using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using NUnit.Framework;
using static Nowpose.Tests.Core.Frames.FedBody;

namespace Nowpose.Tests.Core.Frames
{
    public class BodyJumpTests
    {
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

        // The position from a satellite receiver is 0.12 m wrong. If the vehicle were held there, it would be 0.8 m behind.
        [Test]
        public void Add_VehicleDeviatesLessThanItsSpeed_IsStillPredicted()
        {
            PoseSample Motion(double t) => new PoseSample(t, new Vector3D(6 * t + (t > 99.5 * Interval ? 0.12 : 0), 0, 0), UnitQuaternion.Identity);
            var predictor = Fed("adaptive", Motion, 101);

            Assert.That(predictor.At(100 * Interval + 0.15, out var kind).X, Is.EqualTo(6 * (100 * Interval + 0.15)).Within(0.5));
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

        // The samples before the outlier are used again as soon as the next one shows that it was wrong.
        [Category("Study")]
        [TestCase(0)]
        [TestCase(0.3)]
        public void At_SampleAfterAnOutlierOfACurvedMotion_IsPredictedFromTheSamplesBeforeIt(double outlier)
        {
            Vector3D Position(double t) => new Vector3D(0.3 * Math.Sin(2 * t) + 0.1 * Math.Sin(4.1 * t + 1), 0.25 * Math.Cos(1.7 * t), 0.1 * Math.Sin(2.6 * t));
            var (squares, count) = (0.0, 0);
            for (var wrong = 100; wrong < 500; wrong += 7, count++)
            {
                var predictor = new BodyPredictor("adaptive", new PredictionLimits());
                for (var i = 0; i <= wrong + 1; i++)
                {
                    var position = Position(i * Interval) + new Vector3D(i == wrong ? outlier : 0, 0, 0);
                    predictor.Add(new PoseSample(i * Interval, position, UnitQuaternion.Identity), (i - 1) * Interval + 0.1);
                }
                var time = (wrong + 1) * Interval + 0.1;
                var (pose, truth) = (predictor.At(time), Position(time));
                squares += Math.Pow(pose.X - truth.X, 2) + Math.Pow(pose.Y - truth.Y, 2) + Math.Pow(pose.Z - truth.Z, 2);
            }

            Assert.That(Math.Sqrt(squares / count), Is.LessThan(0.004), "m");
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

        // A planar marker on a turntable: the wrong rotation is about another axis than that of the turntable.
        [TestCase(0.6)]
        [TestCase(3)]
        public void At_OneRotationOfATurningObjectIsWrong_IsPredictedAsBeforeAfterTheNextSample(double error)
        {
            UnitQuaternion Rotation(double t) => UnitQuaternion.Exp(new Vector3D(0, 0, t));
            var predictor = new BodyPredictor("adaptive", new PredictionLimits());
            for (var i = 0; i < 105; i++)
            {
                var wrong = UnitQuaternion.Exp(new Vector3D(i == 100 ? error : 0, 0, 0));
                predictor.Add(new PoseSample(i * Interval, default, Rotation(i * Interval) * wrong), (i - 1) * Interval + 0.1);
                var pose = predictor.At(i * Interval + 0.1, out var kind);
                if (i <= 100) continue;
                Assert.That(UnitQuaternion.AngleBetween(UnitQuaternion.Of(pose), Rotation(i * Interval + 0.1)), Is.LessThan(0.01), $"sample {i}");
                Assert.That(kind, Is.EqualTo(PredictionKind.Predicted), $"sample {i}");
            }
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
    }
}
