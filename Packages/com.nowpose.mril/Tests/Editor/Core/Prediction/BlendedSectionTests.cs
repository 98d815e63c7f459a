using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class BlendedSectionTests
    {
        internal const double Interval = 0.05, TimeConstant = 0.01;
        const double Frame = 1 / 60.0;

        static readonly PredictionLimits Limits = new PredictionLimits();

        // Returns a joint that moves at 1 rad/s, with and without blending. The time of its newest sample is `newest`. Two frames of the blended
        // joint have been displayed, the second of them for the time 100 ms after this sample.
        internal static (DisplayedJoint Blended, JointPredictor Bare) Moving(double newest, PredictionLimits limits = null, string predictor = "linear")
        {
            var bare = Predictors.Create(predictor, limits ?? Limits);
            var blended = new DisplayedJoint(Predictors.Create(predictor, limits ?? Limits, TimeConstant));
            for (var i = 10; i >= 0; i--) Add(blended, bare, newest - i * Interval, newest - i * Interval);
            blended.Show(newest + 0.1 - Frame);
            blended.Show(newest + 0.1);
            return (blended, bare);
        }

        static void Add(DisplayedJoint one, JointPredictor other, double time, double position)
        {
            one.Add(time, position);
            other.Add(time, position);
        }

        [Test]
        public void At_NewSection_StartsAtTheShownPositionAndItsResidualDecaysExponentially()
        {
            var (blended, bare) = Moving(1);
            var shown = blended.Show(1.1).Position;
            Add(blended, bare, 1 + Interval, 1);

            var residual = shown - bare.At(1.1).Position;

            Assert.That(residual, Is.EqualTo(0.1).Within(1e-12), "the joint stopped, so the sections differ");
            foreach (var after in new[] { 0, 0.005, TimeConstant, 0.02, 0.04 })
                Assert.That(
                    blended.Predictor.At(1.1 + after).Position - bare.At(1.1 + after).Position,
                    Is.EqualTo(residual * Math.Exp(-after / TimeConstant)).Within(1e-12), after + " s after");
        }

        [TestCase("linear")]
        [TestCase("cubic")]
        [TestCase("gp")]
        [TestCase("adaptive")]
        public void At_FirstFrameAfterASample_ContinuesThePreviousSection(string predictor)
        {
            const int seed = 17;
            var random = new Random(seed);
            var joint = new DisplayedJoint(Predictors.Create(predictor, Limits, TimeConstant));
            for (var k = 0; k < 400; k++)
            {
                var shown = joint.Show(k * Interval + 0.06).Position;
                // Up to three samples arrive between two frames. The third one is older than the second.
                var samples = k < 5 ? 1 : random.Next(4);
                for (var i = 0; i < samples; i++) joint.Add(k * Interval + (i * 2 % 3 + 1) * 0.015, Math.Sin(2 * (k * Interval + (i * 2 % 3 + 1) * 0.015)));

                if (k > 8) Assert.That(joint.Predictor.At(k * Interval + 0.06).Position, Is.EqualTo(shown).Within(1e-9), "seed " + seed + ", frame " + k);
            }
        }

        [Test]
        public void At_SeveralSamplesBetweenTwoFrames_AreBlendedAsOne()
        {
            var (blended, bare) = Moving(1);
            var shown = blended.Show(1.1).Position;
            for (var i = 1; i <= 3; i++) Add(blended, bare, 1 + i * 0.03, 1);

            Assert.That(shown - bare.At(1.1).Position, Is.EqualTo(0.1).Within(1e-12), "the joint stopped, so the sections differ");
            Assert.That(blended.Show(1.1).Position, Is.EqualTo(shown).Within(1e-12));
            Assert.That(blended.Show(1.1 + 20 * TimeConstant).Position, Is.EqualTo(1).Within(1e-6));
        }

        [Test]
        public void At_FirstSampleAfterAHeldPosition_IsNotBlended()
        {
            var (blended, bare) = Moving(1);
            var held = blended.Show(1 + Limits.HorizonCap + 0.1);
            Assert.That(held.Kind, Is.EqualTo(PredictionKind.Held));
            for (var i = 1; i <= 8; i++) Add(blended, bare, 1 + i * Interval, 1 + i * Interval);

            var time = 1 + Limits.HorizonCap + 0.1 + Frame;
            Assert.That(blended.Show(time).Position, Is.EqualTo(bare.At(time).Position).And.GreaterThan(held.Position + 0.1));
        }

        // Thinning leaves out every second sample, also the newest, so the position is held although the cap after the newest sample is not reached.
        [Test]
        public void At_FirstSampleAfterAHeldPositionAndASampleLeftOut_IsNotBlended()
        {
            var bare = Predictors.Create("adaptive", Limits);
            var blended = new DisplayedJoint(Predictors.Create("adaptive", Limits, TimeConstant));
            for (var i = 101; i >= 0; i--) Add(blended, bare, 1 - i * 0.005, 1 - i * 0.005);
            Assert.That(blended.Show(1 + Limits.HorizonCap - 0.002).Kind, Is.EqualTo(PredictionKind.Held));
            Add(blended, bare, 1.25, 0.9);

            var time = 1 + Limits.HorizonCap - 0.002 + Frame;
            Assert.That(blended.Show(time).Position, Is.EqualTo(bare.At(time).Position).Within(1e-12));
        }

        [Test]
        public void At_FirstSampleAfterAPositionHeldBeyondTheForecasts_IsNotBlended()
        {
            var limits = new PredictionLimits(horizonCap: 1);
            var (blended, bare) = Moving(1, limits, "adaptive");
            blended.Show(1.8);
            for (var i = 1; i <= 16; i++) Add(blended, bare, 1 + i * Interval, 1 + i * Interval);

            Assert.That(blended.Show(1.82).Position, Is.EqualTo(bare.At(1.82).Position).Within(1e-12));
        }

        // A frame may read the position twice, the second time for a later display time. A sample may arrive between the two reads.
        [Test]
        public void At_SampleBetweenTwoReadsOfOneFrame_SecondReadContinuesTheFirst()
        {
            var (blended, bare) = Moving(1);
            var first = blended.Show(1.1 + Frame).Position;
            Add(blended, bare, 1 + Interval, 1);

            Assert.That(blended.Show(1.1 + Frame).Position, Is.EqualTo(first).Within(1e-12));
            Assert.That(blended.Show(1.1 + Frame + 0.003).Position, Is.EqualTo(first).Within(0.3 * (first - bare.At(1.1 + Frame).Position)));
        }

        [Test]
        public void At_NextSectionWhileBlending_ContinuesTheShownPosition()
        {
            var (blended, bare) = Moving(1);
            Add(blended, bare, 1 + Interval, 1);
            var shown = blended.Show(1.1 + 0.001).Position;

            Add(blended, bare, 1 + 2 * Interval, 1);

            Assert.That(blended.Show(1.1 + 0.001).Position, Is.EqualTo(shown).Within(1e-12));
        }

        [Test]
        public void At_LateSample_IsBlended()
        {
            var (blended, bare) = Moving(1, predictor: "quadratic");
            Add(blended, bare, 1 + 2 * Interval, 1.02);
            var shown = blended.Show(1.15).Position;

            Add(blended, bare, 1 + Interval, 1.02);

            Assert.That(blended.Show(1.15).Position, Is.EqualTo(shown).Within(1e-12));
            Assert.That(blended.Show(1.15 + 20 * TimeConstant).Position, Is.EqualTo(bare.At(1.15 + 20 * TimeConstant).Position).Within(1e-6));
        }

        [Test]
        public void At_SamplesInQuickSuccession_TimeConstantIsAFifthOfTheirInterval()
        {
            var blended = new DisplayedJoint(Predictors.Create("linear", Limits, 1));
            for (var i = 0; i <= 20; i++) blended.Add(i * 0.01, i * 0.01);
            var shown = blended.Show(0.3).Position;
            blended.Add(0.21, 0.2);

            var left = blended.Show(0.3 + 0.002).Position - 0.2;

            Assert.That(left / (shown - 0.2), Is.EqualTo(Math.Exp(-1)).Within(1e-9));
        }

        // The sections after the first samples of the new clock were never displayed.
        [Test]
        public void At_SeveralSamplesAfterTheClockWentBack_AreNotBlended()
        {
            const double back = 3600;
            var (blended, bare) = Moving(1);
            foreach (var (k, position) in new[] { (1, 1.0), (2, 1.1), (3, 1.3), (4, 1.6) }) Add(blended, bare, 1 + k * Interval - back, position);

            Assert.That(blended.Predictor.Restarts, Is.EqualTo(1));
            var time = 1 + 4 * Interval - back + 0.1;
            Assert.That(blended.Predictor.At(1.1).Position, Is.EqualTo(bare.At(1.1).Position));
            Assert.That(blended.Show(time).Position, Is.EqualTo(bare.At(time).Position));
        }

        [Test]
        public void At_AngleWraps_IsNotBlended()
        {
            var (blended, bare) = Moving(1);
            for (var i = 1; i <= 4; i++)
            {
                Add(blended, bare, 1 + i * Interval, 1 + i * Interval - 2 * Math.PI);

                Assert.That(blended.Show(1.1 + i * Interval).Position, Is.EqualTo(bare.At(1.1 + i * Interval).Position), "sample " + i);
            }
        }

        [Test]
        public void At_JumpAtRest_IsNotBlended()
        {
            var blended = new DisplayedJoint(Predictors.Create("hold", Limits, TimeConstant));
            for (var i = 0; i <= 20; i++) blended.Add(i * Interval, 0.001 * (i % 2));
            blended.Show(1.1);
            blended.Add(1 + Interval, 0.8);

            Assert.That(blended.Show(1.1 + Frame).Position, Is.EqualTo(0.8));
        }

        [Test]
        public void At_AfterAPauseOfTheDisplay_IsNotBlended()
        {
            var (blended, bare) = Moving(1);
            Add(blended, bare, 1 + Interval, 1);

            Assert.That(blended.Show(1.1 + 0.26).Position, Is.EqualTo(bare.At(1.1 + 0.26).Position).Within(1e-12));
            Assert.That(blended.Show(1.1 + 0.27).Position, Is.EqualTo(bare.At(1.1 + 0.27).Position).Within(1e-12));
        }

        [Test]
        public void At_ResidualBeyondTheJointsLimit_IsClamped()
        {
            var limits = new PredictionLimits(lower: -1, upper: 1.05);
            var (blended, bare) = Moving(1, limits);
            Add(blended, bare, 1 + Interval, 1.05);
            Add(blended, bare, 1 + 2 * Interval, 1.05);

            for (var t = 1.1; t < 1.2; t += 0.001) Assert.That(blended.Show(t).Position, Is.InRange(-1, 1.05));
        }

        [Test]
        public void Reset_WhileBlending_DropsTheShownPosition()
        {
            var (blended, bare) = Moving(1);
            Add(blended, bare, 1 + Interval, 1);
            blended.Predictor.Reset();

            Assert.That(blended.Show(1.1).Kind, Is.EqualTo(PredictionKind.None));
            blended.Add(1.06, 0.3);
            Assert.That(blended.Show(1.11).Position, Is.EqualTo(0.3));
        }

        [Test]
        public void At_TimeConstantZero_IsNotBlended()
        {
            var bare = Predictors.Create("quadratic", Limits);
            var blended = new DisplayedJoint(Predictors.Create("quadratic", Limits));
            for (var i = 0; i < 40; i++)
            {
                Add(blended, bare, i * Interval, Math.Sin(i * Interval * 9));
                Assert.That(blended.Show(i * Interval + 0.1).Position, Is.EqualTo(bare.At(i * Interval + 0.1).Position));
            }
        }

        [TestCase(-0.001)]
        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        public void Create_TimeConstantOutOfRange_IsRefused(double seconds)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => Predictors.Create("linear", Limits, seconds));
        }
    }
}
