using System.Linq;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.State
{
    public class JointPositionCheckTests
    {
        static readonly double[] Smooth = { 0, 1, 2, 3, 4 };

        // Feeds a smooth motion at 1 per sample, and further positions.
        static MotionState After(params double[] positions)
        {
            var buffer = new SampleBuffer<JointSample>(8, PredictionLimits.Unlimited);
            var (motion, k) = (new MotionState(1, 0, 8, buffer.Timing, new JointPositionCheck()), 0);
            foreach (var position in Smooth.Concat(positions))
            {
                buffer.Add(new JointSample(k++ * 0.05, position), displayed: double.NaN);
                motion.Take(buffer);
            }
            return motion;
        }

        [TestCase(50)]
        [TestCase(-50)]
        public void Examine_SampleFurtherAwayThanAnyMotion_IsUnconfirmed(double wrong) =>
            Assert.That(After(wrong).Verdict, Is.EqualTo(PositionVerdict.Unconfirmed));

        // The motion leaves the wrong sample out, so the velocity after it is known.
        [TestCase(50)]
        [TestCase(-50)]
        public void Examine_NextSampleReturns_IsNoJump(double wrong)
        {
            var motion = After(wrong, 6);

            Assert.That((motion.IsPreviousWrong, motion.Verdict), Is.EqualTo((true, PositionVerdict.Right)));
        }

        [TestCase(50)]
        [TestCase(-50)]
        public void At_OneWrongSampleAmongTheSamples_IsNotOnTheCurve(double wrong)
        {
            var predictor = Predictors.Create("adaptive", new PredictionLimits());
            for (var k = 0; k < 8; k++) predictor.Add(new JointSample(k * 0.05, k == 5 ? wrong : k));

            Assert.That(predictor.At(5 * 0.05).Position, Is.EqualTo(5).Within(1e-9));
        }

        // A driver that reports zero a few times.
        [TestCase(2)]
        [TestCase(5)]
        [TestCase(20)]
        public void Examine_ReturnFromSeveralWrongSamples_IsAJump(int wrong)
        {
            var positions = Enumerable.Repeat(500.0, wrong).ToArray();

            Assert.That(After(positions).Verdict, Is.EqualTo(PositionVerdict.Unconfirmed));
            Assert.That(After(positions.Append(5.0 + wrong).ToArray()).Verdict, Is.EqualTo(PositionVerdict.Jumped));
            Assert.That(After(positions.Append(5.0 + wrong).Append(6.0 + wrong).ToArray()).Connected, Is.EqualTo(2));
        }

        [Test]
        public void Examine_JointStaysAtTheOtherPlace_IsConfirmed() =>
            Assert.That(After(Enumerable.Repeat(500.0, 21).ToArray()).Verdict, Is.EqualTo(PositionVerdict.Right));

        // The first move at a much higher speed, and a joint that was moved elsewhere.
        [TestCase(100)]
        [TestCase(50.5)]
        public void Examine_NextSampleDoesNotReturn_IsNoJump(double next) => Assert.That(After(50, next).HasJumped, Is.False);

        [Test]
        public void Examine_MotionAsFastAsEarlier_IsRight() => Assert.That(After(6.5).Verdict, Is.EqualTo(PositionVerdict.Right));
    }
}
