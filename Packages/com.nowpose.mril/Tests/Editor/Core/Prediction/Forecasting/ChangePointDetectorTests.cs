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
    }
}
