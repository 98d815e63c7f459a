using System;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using NUnit.Framework;
using static Nowpose.Tests.Core.Frames.FedBody;

namespace Nowpose.Tests.Core.Frames
{
    public class BodyPredictorTests
    {
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
    }
}
