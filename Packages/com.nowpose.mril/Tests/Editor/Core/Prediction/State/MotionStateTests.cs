using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.State
{
    public class MotionStateTests
    {
        const double Interval = 0.05;

        static MotionState Fed(params double[] positions)
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var motion = new MotionState(1, 0, 8, buffer.Timing);
            for (var k = 0; k < positions.Length; k++)
            {
                buffer.Add(new JointSample(k * Interval, positions[k]), displayed: double.NaN);
                motion.Take(buffer);
            }
            return motion;
        }

        // Returns the maximum number of samples at a standstill while a motion is fed.
        static int MaxStillSamples(Func<int, double> positionOf, int from, int to)
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var (motion, max) = (new MotionState(1, 0, 8, buffer.Timing, new JointPositionCheck()), 0);
            for (var k = 0; k < to; k++)
            {
                buffer.Add(new JointSample(k * Interval, positionOf(k)), displayed: double.NaN);
                motion.Take(buffer);
                if (k >= from) max = Math.Max(max, motion.StillSamples);
            }
            return max;
        }

        [TestCase(2 * Math.PI)]
        [TestCase(1000)]
        public void StillSamples_SlowMotionAfterOneWrongSample_IsNoStandstill(double wrong)
        {
            var samples = MaxStillSamples(k => 0.02 * Math.Sin(2 * k * Interval) + (k == 400 ? wrong : 0), 402, 1000);

            Assert.That(samples, Is.LessThanOrEqualTo(1), "only the samples at a reversal");
        }

        [Test]
        public void StillSamples_MotionOfLessThanATenThousandthOfTheMaximumSpeed_IsAStandstill() =>
            Assert.That(MaxStillSamples(k => k < 10 ? k : 9 + 0.9e-4 * (k - 9), 10, 100), Is.EqualTo(90));

        [Test]
        public void StillSamples_FirstSampleAfterAGap_IsNoStandstill()
        {
            var buffer = new SampleBuffer<JointSample>(8, new PredictionLimits());
            var motion = new MotionState(1, 0, 8, buffer.Timing, new JointPositionCheck());
            foreach (var time in new[] { 0, 0.05, 0.1, 3 })
            {
                buffer.Add(new JointSample(time, 7), displayed: double.NaN);
                motion.Take(buffer);
            }

            Assert.That((motion.StillSamples, motion.Interval, motion.PreviousTime), Is.EqualTo((0, 0.0, 3.0)));
        }

        [Test]
        public void Velocity_AfterALateSample_IsThatBetweenTheNewestThreeSamples()
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var motion = new MotionState(1, 0, 8, buffer.Timing);
            foreach (var (time, position) in new[] { (0, 0), (1, 1), (3, 7), (2, 3) })
            {
                buffer.Add(new JointSample(time, position), displayed: double.NaN);
                motion.Take(buffer);
            }

            Assert.That((motion.Velocity[0], motion.VelocityBefore[0], motion.Interval), Is.EqualTo((4.0, 2.0, 1.0)));
        }

        [TestCase(1, 0.0, 1, 2, 3)]
        [TestCase(0.5, 0.0, 4, 6, 7)]
        [TestCase(0, 0.0, 1, 1, 1)]
        [TestCase(-1, 0.0, 1, 0, 1)]
        [TestCase(1, 5.0, 5, 5)]
        [TestCase(1, 5.0, 6)]
        public void MeasurePersistence_Samples_IsTheMeanRatioOfSuccessiveDisplacementsOrOne(double expected, params double[] positions) =>
            Assert.That(Fed(positions).MeasurePersistence(), Is.EqualTo(expected));
    }
}
