using System;
using NUnit.Framework;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Tests.Core.Prediction.State
{
    public class ChangePointDetectorTests
    {
        const double Interval = 0.05, ForgettingFactor = 0.9975;

        // Feeds a first sample, and one sample per speed.
        static ChangePointDetector After(params double[] speeds)
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var (detector, motion, position) = (new ChangePointDetector(), new MotionState(1, 0, 8, buffer.Timing, new JointPositionCheck()), 0.0);
            for (var k = 0; k <= speeds.Length; k++)
            {
                if (k > 0) position += speeds[k - 1] * Interval;
                buffer.Add(new JointSample(k * Interval, position), displayed: double.NaN);
                motion.Take(buffer);
                detector.Add(motion, ForgettingFactor);
            }
            return detector;
        }

        [TestCase(0.01)]
        [TestCase(-0.01)]
        public void Add_StartFromNoise_IsAnIncreaseInEitherDirectionOfTheNoise(double noise)
        {
            var detector = After(noise, -noise, noise, 1);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((1, true)));
        }

        [Test]
        public void Add_NextSampleConfirmsTheStart_UsesAllSamples() =>
            Assert.That(After(0.01, -0.01, 1, 1.1).SamplesSince, Is.EqualTo(int.MaxValue));

        [Test]
        public void Add_FasterMotionAfterAReversal_IsNotAStart()
        {
            var detector = After(-0.5, -0.4, -0.5, 1, 1.1);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((2, false)));
        }

        [Test]
        public void Add_AbruptStop_LeavesOutEarlierSamples()
        {
            var detector = After(0.9, 1, 1, 1, 0);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((1, false)));
        }

        [Test]
        public void Add_AbruptStopAfterAWrongSample_LeavesOutEarlierSamples()
        {
            var detector = After(0.9, 1, 1, 1, 50, -48, 1, 1.1, 1, 0);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((1, false)));
        }

        [Test]
        public void Add_AbruptStopAfterSeveralWrongSamples_LeavesOutEarlierSamples()
        {
            var detector = After(0.9, 1, 1, 1, 50, 1, 1, -46, 1, 1.1, 1, 0);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((1, false)));
        }

        // The second sample after a gap is wrong. Its acceleration would hide an abrupt stop for about 20 s.
        [Test]
        public void Add_AbruptStopAfterAWrongSampleThatFollowsAGap_LeavesOutEarlierSamples()
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var (detector, motion) = (new ChangePointDetector(), new MotionState(1, 0, 8, buffer.Timing, new JointPositionCheck()));
            for (var k = 0; k < 12; k++)
            {
                var time = (k < 5 ? k : k + 40) * Interval;
                var stop = 50 * Interval;
                buffer.Add(new JointSample(time, Math.Min(time, stop) * (1 + 0.01 * Math.Sin(5 * time)) + (k == 6 ? 20 : 0)), displayed: double.NaN);
                motion.Take(buffer);
                detector.Add(motion, ForgettingFactor);
            }

            Assert.That(detector.SamplesSince, Is.LessThanOrEqualTo(2));
        }

        [Test]
        public void Add_SameVelocityAsBeforeAWrongSample_IsNoChangePoint() =>
            Assert.That(After(0.9, 1, 1, 1, 50, -48, 1.1, 1.1).SamplesSince, Is.EqualTo(int.MaxValue));

        [Test]
        public void Add_AccelerationLikeEarlierOnes_IsNoChangePoint() =>
            Assert.That(After(0.2, 0.4, 0.6, 0.4, 0.2, 0, 0.2).SamplesSince, Is.EqualTo(int.MaxValue));

        // The second displacement of a switched motion is any multiple of the first, because the motion may begin at any time in the first interval.
        [TestCase(0.5)]
        [TestCase(0.8)]
        [TestCase(5)]
        public void Add_StartFromRestWithoutNoise_LeavesOutTheRest(double second) => Assert.That(After(0, 0, 0.1, second).SamplesSince, Is.EqualTo(1));

        [Test]
        public void Add_SwitchedOn_LeavesOutTheRest() => Assert.That(After(0, 0, 0.9, 1, 1).SamplesSince, Is.EqualTo(3));

        // A stop within an interval shows in two intervals.
        [TestCase(0.3)]
        [TestCase(0)]
        public void Add_StopAsFastAsAnEarlierStart_IsAChangePointAfterAConstantVelocity(double rest)
        {
            Assert.That(After(0, 1, 1, 1, rest, 0).SamplesSince, Is.LessThanOrEqualTo(2));
            Assert.That(After(0, 1, 1.01, 1.02, rest, 0).SamplesSince, Is.GreaterThan(2), "without a constant velocity");
        }

        [Test]
        public void Add_JumpOfAnObjectAtConstantVelocity_IsNoChangePoint()
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var (detector, motion) = (new ChangePointDetector(), new MotionState(1, 0, 8, buffer.Timing, new ObjectPositionCheck(1, 0.03, 40)));
            for (var k = 0; k < 8; k++)
            {
                buffer.Add(new JointSample(k * Interval, 0.01 * k + (k < 5 ? 0 : 3)), displayed: double.NaN);
                motion.Take(buffer);
                detector.Add(motion, ForgettingFactor);
            }

            Assert.That((motion.Connected, detector.SamplesSince), Is.EqualTo((3, int.MaxValue)));
        }
    }
}
