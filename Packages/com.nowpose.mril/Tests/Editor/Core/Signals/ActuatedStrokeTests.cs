using System;
using NUnit.Framework;
using Nowpose.Signals;

namespace Nowpose.Tests.Core.Signals
{
    public class ActuatedStrokeTests
    {
        static ControlTime At(double seconds) => ControlTime.FromSeconds(1000 + seconds);

        static ActuatedStroke Open(double strokeSeconds = 0.4)
        {
            var stroke = new ActuatedStroke(0.01, 0.05, strokeSeconds);
            stroke.Change(0, At(0));
            return stroke;
        }

        [Test]
        public void At_WholeStroke_TakesTheStrokeTimeAndIsSymmetric()
        {
            var stroke = Open();
            stroke.Change(1, At(10));

            Assert.That(stroke.At(At(10)), Is.EqualTo(0.01).Within(1e-12));
            Assert.That(stroke.At(At(10.2)), Is.EqualTo(0.03).Within(1e-9), "halfway after half of the time");
            Assert.That(stroke.At(At(10.399)), Is.LessThan(0.05));
            Assert.That(stroke.At(At(10.4 + 1e-6)), Is.EqualTo(0.05).Within(1e-12));
            for (var t = 0.0; t < 0.2; t += 0.01)
                Assert.That(stroke.At(At(10.2 + t)) + stroke.At(At(10.2 - t)), Is.EqualTo(0.06).Within(1e-9), t + " s from the middle");
        }

        [Test]
        public void Change_ReceivedLate_JoinsTheMotionOfATimelyChange()
        {
            var (inTime, late) = (Open(), Open());
            inTime.Change(1, At(10));

            late.At(At(10.15));
            late.Change(1, At(10));

            for (var t = 10.15; t < 10.6; t += 0.01) Assert.That(late.At(At(t)), Is.EqualTo(inTime.At(At(t))).Within(1e-12));
        }

        [Test]
        public void Change_DuringAMove_ContinuesFromTheCurrentPosition()
        {
            var stroke = Open();
            stroke.Change(1, At(10));
            var turned = stroke.At(At(10.25));

            stroke.Change(0, At(10.25));

            Assert.That(stroke.At(At(10.25)), Is.EqualTo(turned).Within(1e-12));
            Assert.That(stroke.At(At(10.7)), Is.EqualTo(0.01).Within(1e-9));
            Assert.That(stroke.At(At(10.45)), Is.LessThan(turned));
        }

        [TestCase(0.25, 0.02)]
        [TestCase(2, 0.05)]
        [TestCase(-1, 0.01)]
        public void Change_Number_IsAPositionBetweenTheEnds(double value, double expected)
        {
            var stroke = Open();
            stroke.Change(value, At(10));

            Assert.That(stroke.At(At(11)), Is.EqualTo(expected).Within(1e-9));
        }

        // A jaw that opens in the stroke time and closes again, with its measured opening every 20 ms.
        [TestCase(0, 1)]
        [TestCase(0.4, 1)]
        [TestCase(1, 0)]
        [TestCase(0.9, 0.3)]
        public void Change_MeasuredRamp_FollowsTheValues(double first, double last)
        {
            var stroke = new ActuatedStroke(0, 1, 0.3);
            stroke.Change(first, At(0));

            for (var i = 1; i <= 30; i++)
            {
                var value = first + (last - first) * Math.Min(i, 30 - i) / 15;
                stroke.Change(value, At(10 + 0.02 * i));

                if (i == 1) continue;
                for (var t = 0.0; t <= 0.02; t += 0.005)
                    Assert.That(stroke.At(At(10 + 0.02 * i + t)), Is.EqualTo(value).Within(1e-12), $"value {i}, {t} s");
            }
        }

        [TestCase(0.4)]
        [TestCase(0.7)]
        public void Change_SingleStepBetweenTheEnds_IsAMove(double value)
        {
            var stroke = Open();

            stroke.Change(value, At(10));

            var to = 0.01 + 0.04 * value;
            Assert.That(stroke.At(At(10)), Is.EqualTo(0.01).Within(1e-12));
            Assert.That(stroke.At(At(10.1)), Is.InRange(0.01 + 0.1 * (to - 0.01), to - 0.1 * (to - 0.01)));
            Assert.That(stroke.At(At(10.4)), Is.EqualTo(to).Within(1e-9));
        }

        [Test]
        public void Change_NoiseDuringAMoveToTheEnd_DoesNotStartTheMoveAgain()
        {
            var (steady, noisy) = (Open(), Open());
            steady.Change(1, At(10));
            noisy.Change(1, At(10));

            for (var i = 1; i < 20; i++)
            {
                noisy.Change(i % 2 == 0 ? 1 : 0.999, At(10 + 0.02 * i));

                Assert.That(noisy.At(At(10.01 + 0.02 * i)), Is.EqualTo(steady.At(At(10.01 + 0.02 * i))).Within(1e-12), $"value {i}");
            }
        }

        [Test]
        public void Change_FirstValue_AppliesImmediately()
        {
            var stroke = new ActuatedStroke(0, 1, 0.4);

            stroke.Change(1, At(10));

            Assert.That(stroke.At(At(10)), Is.EqualTo(1));
        }

        [Test]
        public void Change_StrokeTimeZero_Jumps()
        {
            var stroke = Open(0);

            stroke.Change(1, At(10));

            Assert.That(stroke.At(At(10)), Is.EqualTo(0.05));
        }

        [Test]
        public void Forget_DuringAMove_TheNextValueSetsThePosition()
        {
            var stroke = Open();
            stroke.Change(1, At(10));

            stroke.Forget();
            stroke.Change(1, At(-300));

            Assert.That(stroke.At(At(-300)), Is.EqualTo(0.05));
        }
    }
}
