using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class EndlessJointTests
    {
        const double Turn = 2 * Math.PI;

        static readonly PredictionLimits Endless = new PredictionLimits(
            horizonCap: double.PositiveInfinity, maximumGap: double.PositiveInfinity, isEndless: true);

        [TestCase("quadratic")]
        [TestCase("adaptive")]
        public void At_AngleWrapsAtPi_ContinuesTheMotion(string name)
        {
            var predictor = Predictors.Create(name, Endless);
            var worst = 0.0;
            for (var k = 0; k < 400; k++)
            {
                var t = k * 0.05;
                predictor.Add(t, Wrapped(2 * t));
                var off = Wrapped(predictor.At(t + 0.1).Position - 2 * (t + 0.1));
                if (k > 10) worst = Math.Max(worst, Math.Abs(off));
            }

            Assert.That(worst, Is.LessThan(0.01), "a full turn is 6.28 rad");
        }

        [Test]
        public void Hold_AngleWraps_IsTheUnchangedNewestSample()
        {
            var predictor = Predictors.Create("linear", Endless);
            predictor.Add(0, 3.1);
            predictor.Add(0.05, -3.1);

            Assert.That(predictor.Hold, Is.EqualTo(-3.1).Within(1e-12));
            Assert.That(predictor.At(0.05).Position, Is.EqualTo(-3.1).Within(1e-9));
        }

        [Test]
        public void Create_JointNotEndless_DoesNotUnwrap()
        {
            var predictor = Predictors.Create("linear", PredictionLimits.Unlimited);
            predictor.Add(0, 0);
            predictor.Add(1, 10);

            Assert.That(predictor.At(2).Position, Is.EqualTo(20).Within(1e-9), "ten metres of a linear joint are not wrapped like an angle");
        }

        static double Wrapped(double angle) => angle - Turn * Math.Round(angle / Turn);
    }
}
