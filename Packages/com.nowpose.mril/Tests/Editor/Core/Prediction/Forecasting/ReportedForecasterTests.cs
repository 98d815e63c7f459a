using System;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class ReportedForecasterTests
    {
        const double Interval = 0.05;

        // At a rest without noise nothing is learned, so the weights of the first move are the prior for reported values, whose parabola is exact here.
        [TestCase(0)]
        [TestCase(1)]
        public void At_StartWithReportedValues_IsForecastWithTheirPrior(int firstReported)
        {
            var predictor = Predictors.Create("adaptive", new PredictionLimits());
            for (var k = 0; k <= 23; k++)
            {
                var (moved, acceleration) = (Math.Max(0, k - 20) * Interval, k <= 20 ? 0 : 4.0);
                var (velocity, reported) = k < firstReported ? (double.NaN, double.NaN) : (acceleration * moved, acceleration);
                predictor.Add(new JointSample(k * Interval, 0.5 * acceleration * moved * moved, k * Interval, velocity, reported), k * Interval + 0.1);
            }

            double parabola = 0.5 * 4 * 0.25 * 0.25, line = 0.5 * 4 * 0.15 * 0.15 + 0.1 * 0.5;
            Assert.That(predictor.At(23 * Interval + 0.1).Position, Is.InRange(0.3 * line + 0.7 * parabola, parabola));
        }
    }
}
