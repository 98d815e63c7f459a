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

        // The joint stops abruptly between two samples. The second of them reports that it stands still.
        [Test]
        public void At_SampleAfterAStopWithReportedValues_UsesThem()
        {
            double Position(double t) => Math.Min(t, 1.025) + 0.01 * Math.Sin(20 * Math.Min(t, 1.025));
            double Velocity(double t) => t < 1.025 ? 1 + 0.2 * Math.Cos(20 * t) : 0;
            double Error(bool isReported)
            {
                var predictor = Predictors.Create("adaptive", new PredictionLimits());
                for (var k = 0; k <= 21; k++)
                {
                    var time = k * Interval;
                    var acceleration = time < 1.025 ? -4 * Math.Sin(20 * time) : 0;
                    predictor.Add(new JointSample(time, Position(time), time, isReported ? Velocity(time) : double.NaN, isReported ? acceleration : double.NaN), time + 0.1);
                }
                return Math.Abs(predictor.At(21 * Interval + 0.1).Position - Position(2));
            }

            Assert.That(Error(isReported: true), Is.LessThan(0.5 * Error(isReported: false)));
        }
    }
}
