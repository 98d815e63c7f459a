using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class BlendedPredictorTests
    {
        const double Interval = 0.05;
        const double TimeConstant = 0.01;
        const double Frame = 1 / 60.0;

        static readonly PredictionLimits Limits = new PredictionLimits();

        // A joint at 1 rad/s, its samples 100 ms late, up to the one at `newest`; two frames have been shown.
        static (BlendedPredictor Blended, IJointPredictor Inner) Moving(double newest, PredictionLimits limits = null, string predictor = "linear")
        {
            var inner = Predictors.Create(predictor, limits ?? Limits);
            var blended = new BlendedPredictor(Predictors.Create(predictor, limits ?? Limits), limits ?? Limits, TimeConstant);
            for (var i = 10; i >= 0; i--) Add(blended, inner, newest - i * Interval, newest - i * Interval);
            blended.At(newest + 0.1 - Frame);
            blended.At(newest + 0.1);
            return (blended, inner);
        }

        static void Add(IJointPredictor one, IJointPredictor other, double time, double position)
        {
            one.Add(new JointSample(time, position));
            other.Add(new JointSample(time, position));
        }

        [Test]
        public void At_NewSection_StartsFromWhatWasShownAndDecaysByE()
        {
            var (blended, inner) = Moving(1);
            var shown = blended.At(1.1).Position;
            Add(blended, inner, 1 + Interval, 1);

            var residual = shown - inner.At(1.1).Position;

            Assert.That(residual, Is.EqualTo(0.1).Within(1e-12), "the joint stopped: the effect is there");
            foreach (var after in new[] { 0, 0.005, TimeConstant, 0.02, 0.04 })
                Assert.That(
                    blended.At(1.1 + after).Position - inner.At(1.1 + after).Position,
                    Is.EqualTo(residual * Math.Exp(-after / TimeConstant)).Within(1e-12), after + " s after");
        }

        [Test]
        public void At_SameMomentTwice_IsTheSame()
        {
            var (blended, inner) = Moving(1);
            Add(blended, inner, 1 + Interval, 1);

            var once = blended.At(1.1 + Frame).Position;

            Assert.That(blended.At(1.1 + Frame).Position, Is.EqualTo(once));
            Assert.That(once, Is.Not.EqualTo(inner.At(1.1 + Frame).Position).Within(1e-3), "blended");
        }

        // The second look of a frame comes with the newer time, and may come after a sample that the first did not know.
        [Test]
        public void At_SampleBetweenTwoLooksOfOneFrame_ContinuesTheFirst()
        {
            var (blended, inner) = Moving(1);
            var first = blended.At(1.1 + Frame).Position;
            Add(blended, inner, 1 + Interval, 1);

            Assert.That(blended.At(1.1 + Frame).Position, Is.EqualTo(first).Within(1e-12));
            Assert.That(blended.At(1.1 + Frame + 0.003).Position, Is.EqualTo(first).Within(0.3 * (first - inner.At(1.1 + Frame).Position)));
        }

        [Test]
        public void At_NextSectionWhileBlending_ContinuesWhatIsShown()
        {
            var (blended, inner) = Moving(1);
            Add(blended, inner, 1 + Interval, 1);
            var shown = blended.At(1.1 + 0.001).Position;

            Add(blended, inner, 1 + 2 * Interval, 1);

            Assert.That(blended.At(1.1 + 0.001).Position, Is.EqualTo(shown).Within(1e-12));
        }

        [Test]
        public void At_LateSample_IsBlendedToo()
        {
            var (blended, inner) = Moving(1, predictor: "quadratic");
            Add(blended, inner, 1 + 2 * Interval, 1.02);
            var shown = blended.At(1.15).Position;

            Add(blended, inner, 1 + Interval, 1.02);

            Assert.That(blended.At(1.15).Position, Is.EqualTo(shown).Within(1e-12));
            Assert.That(blended.At(1.15 + 20 * TimeConstant).Position, Is.EqualTo(inner.At(1.15 + 20 * TimeConstant).Position).Within(1e-6));
        }

        [Test]
        public void At_SamplesInQuickSuccession_BlendWithinAFifthOfTheirInterval()
        {
            var blended = new BlendedPredictor(new HoldPredictor(Limits), Limits, 1);
            for (var i = 0; i <= 20; i++) blended.Add(new JointSample(i * 0.01, i * 0.01));
            var shown = blended.At(0.3).Position;
            blended.Add(new JointSample(0.21, 0.21));

            var left = blended.At(0.3 + 0.002).Position - 0.21;

            Assert.That(left / (shown - 0.21), Is.EqualTo(Math.Exp(-1)).Within(1e-9));
        }

        [Test]
        public void At_AngleWraps_IsShownAtOnce()
        {
            var (blended, inner) = Moving(1);
            for (var i = 1; i <= 4; i++)
            {
                Add(blended, inner, 1 + i * Interval, 1 + i * Interval - 2 * Math.PI);

                Assert.That(blended.At(1.1 + i * Interval).Position, Is.EqualTo(inner.At(1.1 + i * Interval).Position), "sample " + i);
            }
        }

        [Test]
        public void At_SetElsewhereWhileAtRest_IsShownAtOnce()
        {
            var blended = new BlendedPredictor(new HoldPredictor(Limits), Limits, TimeConstant);
            for (var i = 0; i <= 20; i++) blended.Add(new JointSample(i * Interval, 0.001 * (i % 2)));
            blended.At(1.1);
            blended.Add(new JointSample(1 + Interval, 0.8));

            Assert.That(blended.At(1.1 + Frame).Position, Is.EqualTo(0.8));
        }

        [Test]
        public void At_AfterAPauseOfTheDisplay_IsTheSection()
        {
            var (blended, inner) = Moving(1);
            Add(blended, inner, 1 + Interval, 1);

            Assert.That(blended.At(1.1 + 0.26).Position, Is.EqualTo(inner.At(1.1 + 0.26).Position));
            Assert.That(blended.At(1.1 + 0.27).Position, Is.EqualTo(inner.At(1.1 + 0.27).Position));
        }

        [Test]
        public void At_SectionBeyondTheHorizon_StaysHeldAndBlends()
        {
            var (blended, inner) = Moving(1);
            var shown = blended.At(1.32);
            Add(blended, inner, 1 + Interval, 1);

            Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Held));
            Assert.That(blended.At(1.32).Position, Is.EqualTo(shown.Position).Within(1e-12));
        }

        [Test]
        public void At_ResidualBeyondTheJointsLimit_StaysWithinIt()
        {
            var limits = new PredictionLimits(lower: -1, upper: 1.05);
            var (blended, inner) = Moving(1, limits);
            Add(blended, inner, 1 + Interval, 1.05);
            Add(blended, inner, 1 + 2 * Interval, 1.05);

            for (var t = 1.1; t < 1.2; t += 0.001) Assert.That(blended.At(t).Position, Is.InRange(-1, 1.05));
        }

        [Test]
        public void Reset_WhileBlending_ForgetsWhatWasShown()
        {
            var (blended, inner) = Moving(1);
            Add(blended, inner, 1 + Interval, 1);
            blended.Reset();

            Assert.That(blended.At(1.1).Kind, Is.EqualTo(PredictionKind.None));
            blended.Add(new JointSample(1.06, 0.3));
            Assert.That(blended.At(1.11).Position, Is.EqualTo(0.3));
        }

        [Test]
        public void At_TimeConstantZero_IsTheSection()
        {
            var inner = Predictors.Create("quadratic", Limits);
            var blended = new BlendedPredictor(Predictors.Create("quadratic", Limits), Limits, 0);
            for (var i = 0; i < 40; i++)
            {
                Add(blended, inner, i * Interval, Math.Sin(i * Interval * 9));
                Assert.That(blended.At(i * Interval + 0.1).Position, Is.EqualTo(inner.At(i * Interval + 0.1).Position));
            }
        }

        [TestCase(-0.001)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Create_TimeConstantOutOfRange_IsRefused(double seconds)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new BlendedPredictor(new HoldPredictor(Limits), Limits, seconds));
        }
    }
}
