using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class AxisPredictorTests
    {
        const double Interval = 0.05;

        static AxisPredictor New(bool waitsForChange = true, string predictor = "linear") =>
            new AxisPredictor(Predictors.Create(predictor, PredictionLimits.Unlimited), waitsForChange);

        static DropReason Add(AxisPredictor axis, int k, double value) =>
            axis.Add(new JointSample(k * Interval, value), k * Interval + 0.1);

        static AxisPredictor AtRest(int samples, string predictor = "linear")
        {
            var axis = New(predictor: predictor);
            for (var k = 0; k < samples; k++) Add(axis, k, 0.7);
            return axis;
        }

        // Returns the position at sample k of an axis that rests for the first samples and then moves.
        static double Motion(int k, int rest) => k < rest ? 0.7 : 0.7 + 0.02 * (k - rest + 1) * (k - rest + 1);

        [TestCase(true)]
        [TestCase(false)]
        public void Hold_BeforeTheFirstSample_IsZero(bool waitsForChange)
        {
            var axis = New(waitsForChange);

            Assert.That((axis.Hold, axis.At(3)), Is.EqualTo((0.0, 0.0)));
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(20)]
        public void At_ConstantValue_ReturnsTheValueAtAnyTime(int samples)
        {
            var axis = AtRest(samples);

            foreach (var time in new[] { -1, 0, 0.01, 0.5, 3, 1e6 }) Assert.That(axis.At(time), Is.EqualTo(0.7));
            Assert.That(axis.Hold, Is.EqualTo(0.7));
        }

        [Test]
        public void At_DifferencesWithinRounding_ReturnsTheFirstValue()
        {
            var axis = New();
            for (var k = 0; k < 20; k++) Add(axis, k, 0.7 + 4e-11 * k);

            Assert.That((axis.At(3), axis.Hold), Is.EqualTo((0.7, 0.7)));
        }

        /// <summary>
        /// The displacement between two samples of a slow motion is within the rounding tolerance, but the sum of the displacements is not.
        /// </summary>
        [Test]
        public void At_SlowMotion_IsPredicted()
        {
            var axis = New();
            for (var k = 0; k <= 100; k++) Add(axis, k, 4e-11 * k);

            Assert.That(axis.At(110 * Interval), Is.EqualTo(4e-11 * 110).Within(1e-15));
        }

        [Test]
        public void At_AfterTheFirstChange_PredictsTheMotion()
        {
            var axis = AtRest(20);

            Add(axis, 20, 0.8);

            Assert.That(axis.At(22 * Interval), Is.EqualTo(1).Within(1e-12));
            Assert.That(axis.Hold, Is.EqualTo(0.8));
        }

        /// <summary>
        /// After a rest that lasts at most as many samples as the predictor keeps, the prediction is the same as if the predictor had received all
        /// samples.
        /// </summary>
        [Test]
        public void At_AfterARest_EqualsAPredictorThatUsedAllSamples(
            [Values("hold", "linear", "quadratic", "quadratic-h4", "linear-h9", "gp", "adaptive")] string predictor, [Values(1, 2, 5, 8)] int rest)
        {
            AxisPredictor waits = New(predictor: predictor), all = New(waitsForChange: false, predictor);
            for (var k = 0; k < 40; k++)
            {
                var outcome = Add(all, k, Motion(k, rest));
                Assert.That(Add(waits, k, Motion(k, rest)), Is.EqualTo(outcome));
                foreach (var ahead in new[] { 0, 0.06, 0.15 })
                    Assert.That(waits.At(k * Interval + ahead), Is.EqualTo(k < rest ? 0.7 : all.At(k * Interval + ahead)).Within(1e-9), "sample " + k);
                Assert.That(waits.Hold, Is.EqualTo(Motion(k, rest)));
            }
        }

        /// <summary>
        /// The rest lasts for more samples than the predictor keeps. The additional samples are outside the window of these polynomials.
        /// </summary>
        [TestCase("linear")]
        [TestCase("quadratic")]
        [TestCase("quadratic-h4")]
        [TestCase("cubic")]
        public void At_AfterALongRest_EqualsAPredictorThatUsedAllSamples(string predictor)
        {
            AxisPredictor waits = New(predictor: predictor), all = New(waitsForChange: false, predictor);
            for (var k = 0; k < 120; k++)
            {
                Add(all, k, Motion(k, 100));
                Add(waits, k, Motion(k, 100));
                Assert.That(waits.At(k * Interval + 0.1), Is.EqualTo(all.At(k * Interval + 0.1)).Within(1e-12), "sample " + k);
            }
        }

        [TestCase("linear")]
        [TestCase("adaptive")]
        public void At_WithoutWaitingForAChange_EqualsTheJointPredictor(string predictor)
        {
            var axis = New(waitsForChange: false, predictor);
            var joint = Predictors.Create(predictor, PredictionLimits.Unlimited);
            for (var k = 0; k < 40; k++)
            {
                Assert.That(Add(axis, k, Motion(k, 20)), Is.EqualTo(joint.Add(new JointSample(k * Interval, Motion(k, 20)), k * Interval + 0.1)));
                Assert.That(axis.At(k * Interval + 0.1), Is.EqualTo(joint.At(k * Interval + 0.1).Position));
            }
        }

        [Test]
        public void Add_LateSampleAtRest_ChangesNothing()
        {
            AxisPredictor inOrder = AtRest(10), late = AtRest(9);

            // All samples have the value of the rest. Samples 8 and 9 arrive twice.
            foreach (var k in new[] { 9, 8, 9 }) Assert.That(Add(late, k, 0.7), Is.EqualTo(DropReason.None));

            Assert.That(late.At(1), Is.EqualTo(0.7));
            Add(inOrder, 10, 0.8);
            Add(late, 10, 0.8);
            Assert.That(late.At(11 * Interval), Is.EqualTo(inOrder.At(11 * Interval)));
        }

        [Test]
        public void Add_FirstChangeIsLate_IsInsertedInOrder()
        {
            AxisPredictor inOrder = AtRest(10, "quadratic"), late = AtRest(10, "quadratic");
            for (var k = 10; k < 13; k++) Add(inOrder, k, k == 11 ? 0.7 : Motion(k, 10));

            // Sample 11 has the value of the rest, and arrives before sample 10, which has another value.
            Assert.That(Add(late, 11, 0.7), Is.EqualTo(DropReason.None));
            Assert.That(Add(late, 10, Motion(10, 10)), Is.EqualTo(DropReason.None));
            Assert.That(late.Hold, Is.EqualTo(0.7), "the newest sample");
            Assert.That(Add(late, 12, Motion(12, 10)), Is.EqualTo(DropReason.None));

            Assert.That(late.At(14 * Interval), Is.EqualTo(inOrder.At(14 * Interval)).Within(1e-12));
        }

        [Test]
        public void Add_AfterAChange_ReturnsTheDropReasonOfEachSample()
        {
            var axis = AtRest(10);
            Add(axis, 10, 0.8);

            Assert.That(Add(axis, 10, 0.8), Is.EqualTo(DropReason.DuplicateSample));
            Assert.That(Add(axis, 11, 0.9), Is.EqualTo(DropReason.None));
            Assert.That(Add(axis, 1, 0.7), Is.EqualTo(DropReason.LateSample), "before the kept samples");
        }

        [Test]
        public void Add_ValueReturnsToTheFirstValue_IsStillPredicted()
        {
            var axis = AtRest(10);
            Add(axis, 10, 0.8);

            Add(axis, 11, 0.7);

            Assert.That(axis.At(12 * Interval), Is.EqualTo(0.6).Within(1e-12), "the line through the two newest samples");
        }

        [Test]
        public void Reset_AfterAChange_WaitsForTheNextChange()
        {
            var axis = AtRest(3);
            Add(axis, 3, 2);

            axis.Reset();
            Assert.That((axis.Hold, axis.At(1)), Is.EqualTo((0.0, 0.0)));
            Add(axis, 4, 5);
            Add(axis, 5, 5);
            Assert.That(axis.At(7 * Interval), Is.EqualTo(5));
            Add(axis, 6, 6);

            Assert.That(axis.At(7 * Interval), Is.EqualTo(7).Within(1e-12), "no sample from before the reset");
        }
    }
}
