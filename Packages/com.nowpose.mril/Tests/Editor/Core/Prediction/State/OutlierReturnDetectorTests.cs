using System.Linq;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.State
{
    public class OutlierReturnDetectorTests
    {
        static readonly double[] Smooth = { 0, 1, 2, 3, 4 };

        // Feeds a smooth motion at 1 per sample, and further positions.
        static OutlierReturnDetector After(params double[] positions)
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionParts.None, PredictionLimits.Unlimited);
            var (detector, motion, k) = (new OutlierReturnDetector(), new MotionState(1, 0, 8, buffer.Timing, omitsWrong: true), 0);
            void Feed(double position)
            {
                buffer.Add(new JointSample(k++ * 0.05, position), displayed: double.NaN);
                motion.Take(buffer);
                detector.Add(motion);
            }
            foreach (var position in Smooth) Feed(position);
            foreach (var position in positions) Feed(position);
            return detector;
        }

        [TestCase(50)]
        [TestCase(-50)]
        public void Add_SampleFurtherAwayThanAnyMotion_IsUnconfirmed(double wrong)
        {
            var detector = After(wrong);

            Assert.That((detector.IsUnconfirmed, detector.IsVelocityUnknown), Is.EqualTo((true, false)));
        }

        // The motion leaves the wrong sample out, so the velocity after it is known.
        [TestCase(50)]
        [TestCase(-50)]
        public void Add_NextSampleReturns_IsNoJump(double wrong)
        {
            var detector = After(wrong, 6);

            Assert.That((detector.IsUnconfirmed, detector.IsVelocityUnknown), Is.EqualTo((false, false)));
        }

        // A driver that reports zero a few times.
        [TestCase(2)]
        [TestCase(5)]
        [TestCase(20)]
        public void Add_ReturnFromSeveralWrongSamples_IsAJump(int wrong)
        {
            var positions = Enumerable.Repeat(500.0, wrong).ToArray();

            Assert.That((After(positions).IsUnconfirmed, After(positions).IsVelocityUnknown), Is.EqualTo((true, false)));
            Assert.That(After(positions.Append(5.0 + wrong).ToArray()).IsVelocityUnknown, Is.True);
            Assert.That(After(positions.Append(5.0 + wrong).Append(6.0 + wrong).ToArray()).SamplesSince, Is.EqualTo(2));
        }

        [Test]
        public void Add_JointStaysAtTheOtherPlace_IsConfirmed() =>
            Assert.That(After(Enumerable.Repeat(500.0, 21).ToArray()).IsUnconfirmed, Is.False);

        // The first move at a much higher speed, and a joint that was moved elsewhere.
        [TestCase(100)]
        [TestCase(50.5)]
        public void Add_NextSampleDoesNotReturn_IsNoJump(double next) => Assert.That(After(50, next).IsVelocityUnknown, Is.False);

        [Test]
        public void Add_MotionAsFastAsEarlier_IsNotUnconfirmed() => Assert.That(After(6.5).IsUnconfirmed, Is.False);
    }
}
