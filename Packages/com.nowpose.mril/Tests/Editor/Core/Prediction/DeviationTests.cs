using System;
using System.Linq;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    /// <summary>Tests the standard deviation that <c>gp</c> reports for its own forecasts.</summary>
    public class DeviationTests
    {
        const double Interval = 0.05;

        static readonly string[] Others = Predictors.Names.Where(name => name != "gp").ToArray();

        static double Waves(double t) => 100 * Math.Sin(2 * t) + 30 * Math.Sin(7 * t);

        // When a sample is added, the newest displayed time is 100 ms after the time of this sample.
        static JointPredictor Fed(string name, Func<double, double> motion, int samples, PredictionLimits limits = null)
        {
            var predictor = Predictors.Create(name, limits ?? PredictionLimits.Unlimited);
            for (var i = 0; i < samples; i++) predictor.Add(new JointSample(i * Interval, motion(i * Interval)), i * Interval + 0.1);
            return predictor;
        }

        [Test]
        public void DeviationAt_LongerHorizon_IsLarger()
        {
            var predictor = Fed("gp", Waves, 100);

            for (var ahead = 0.01; ahead < 0.4; ahead += 0.01)
                Assert.That(predictor.DeviationAt(predictor.NewestTime + ahead + 0.01),
                    Is.GreaterThan(1.01 * predictor.DeviationAt(predictor.NewestTime + ahead)), $"{ahead} s ahead");
        }

        [Test]
        public void DeviationAt_NewestSample_IsSmallButPositive()
        {
            var predictor = Fed("gp", Waves, 100);

            var atSample = predictor.DeviationAt(predictor.NewestTime);

            Assert.That(atSample, Is.Positive);
            Assert.That(atSample, Is.LessThan(0.02 * predictor.DeviationAt(predictor.NewestTime + 0.1)));
        }

        [Test]
        public void DeviationAt_MotionTenTimesLarger_IsTenTimesLarger()
        {
            var (one, ten) = (Fed("gp", Waves, 100), Fed("gp", t => 10 * Waves(t) + 5, 100));

            Assert.That(ten.DeviationAt(5.1), Is.EqualTo(10 * one.DeviationAt(5.1)).Within(1e-6).Percent);
        }

        [Test]
        public void DeviationAt_ConstantVelocity_IsFarSmallerThanInVaryingMotion()
        {
            var steady = Fed("gp", t => 100 * t, 100);

            Assert.That(steady.DeviationAt(5.1), Is.LessThan(0.01 * Fed("gp", Waves, 100).DeviationAt(5.1)));
        }

        [Test]
        public void DeviationAt_AfterAChangeOfMotion_FollowsWithinAMinute()
        {
            double Quiet(double t) => t < 20 ? Waves(t) : Waves(20) + 0.01 * (Waves(t) - Waves(20));

            var (before, after) = (Fed("gp", Quiet, 400), Fed("gp", Quiet, 1300));

            // The motion changed 45 s ago. The variance decays by a factor of e every 3 s, towards the errors of the new motion.
            Assert.That(after.DeviationAt(65.1) / before.DeviationAt(20.1), Is.InRange(0.005, 0.02));
        }

        [TestCase(5)]
        [TestCase(1)]
        [TestCase(0)]
        public void DeviationAt_BeforeAForecastIsScored_IsUnknown(int samples)
        {
            Assert.That(Fed("gp", Waves, samples).DeviationAt(samples * Interval + 0.1), Is.NaN);
            Assert.That(Fed("gp", Waves, 6).DeviationAt(6 * Interval + 0.1), Is.Positive);
        }

        [Test]
        public void DeviationAt_OutsideTheForecast_IsUnknown()
        {
            var predictor = Fed("gp", Waves, 100, new PredictionLimits(horizonCap: 0.3));

            Assert.That(predictor.DeviationAt(predictor.NewestTime - 0.01), Is.NaN);
            Assert.That(predictor.DeviationAt(predictor.NewestTime + 0.31), Is.NaN);
            Assert.That(predictor.DeviationAt(double.NaN), Is.NaN);
            Assert.That(predictor.DeviationAt(predictor.NewestTime + 0.29), Is.Positive);
        }

        [Test]
        public void DeviationAt_AfterReset_IsUnknown()
        {
            var predictor = Fed("gp", Waves, 100);

            predictor.Reset();
            for (var i = 0; i < 5; i++) predictor.Add(new JointSample(i * Interval, Waves(i * Interval)));

            Assert.That(predictor.DeviationAt(0.3), Is.NaN);
        }

        [TestCaseSource(nameof(Others))]
        public void DeviationAt_PredictorWithoutADeviation_IsUnknown(string name) =>
            Assert.That(Fed(name, Waves, 100).DeviationAt(5.1), Is.NaN);
    }
}
