using Nowpose.Prediction.Forecasting;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class ChangePointDetectorTests
    {
        const double Interval = 0.05;

        static ChangePointDetector After(params double[] speeds)
        {
            var (detector, before) = (new ChangePointDetector(), 0.0);
            for (var k = 0; k < speeds.Length; k++)
            {
                detector.Add(k + 2, Interval, Interval, new SpeedChange(speeds[k], before));
                before = speeds[k];
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
            Assert.That(After(0.01, -0.01, 1, 1).SamplesSince, Is.EqualTo(5));

        [Test]
        public void Add_FasterMotionAfterAReversal_IsNotAStart()
        {
            var detector = After(-0.5, -0.5, -0.5, 1, 1);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((2, false)));
        }

        [Test]
        public void Add_AbruptStop_LeavesOutEarlierSamples()
        {
            var detector = After(0.9, 1, 1, 1, 0);

            Assert.That((detector.SamplesSince, detector.SpeedIncreased), Is.EqualTo((1, false)));
        }

        [Test]
        public void Add_AccelerationLikeEarlierOnes_IsNoChangePoint() =>
            Assert.That(After(0.2, 0.4, 0.6, 0.4, 0.2, 0, 0.2).SamplesSince, Is.EqualTo(8));

        // A smooth start from rest has displacements of 1 and 7 or more in its first two intervals.
        [TestCase(0.5, 1)]
        [TestCase(0.8, 5)]
        public void Add_StartFromRestWithoutNoise_UsesEarlierSamplesOnlyIfItIsSmooth(double second, int expected)
        {
            var detector = After(0, 0);
            detector.Add(4, Interval, Interval, new SpeedChange(0.1, 0), wasSteady: true);
            detector.Add(5, Interval, Interval, new SpeedChange(second, 0.1), wasSteady: true);

            Assert.That(detector.SamplesSince, Is.EqualTo(expected));
        }

        [TestCase(false, 6)]
        [TestCase(true, 1)]
        public void Add_StopAsFastAsAnEarlierStart_IsAChangePointOnlyAfterAConstantVelocity(bool wasSteady, int expected)
        {
            var detector = After(0, 1, 1, 1);
            detector.Add(6, Interval, Interval, new SpeedChange(0, 1), wasSteady);

            Assert.That(detector.SamplesSince, Is.EqualTo(expected));
        }
    }
}
