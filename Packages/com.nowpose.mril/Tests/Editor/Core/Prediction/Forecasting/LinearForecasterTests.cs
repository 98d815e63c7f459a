using System;
using Nowpose.Prediction.Forecasting;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class LinearForecasterTests
    {
        [TestCase("quadratic")]
        [TestCase("process")]
        public void Fill_AnyWeights_EqualsAtForEveryPoint(string name)
        {
            var weights = New(name);
            var forecaster = new LinearForecaster(weights);
            forecaster.Solve(Motion(seed: 1, weights.Samples));
            var table = new double[ForecastTable.Points + 1];
            forecaster.Fill(table, 1, ForecastTable.Points, components: 1);

            for (var i = 0; i < ForecastTable.Points; i++)
                Assert.That(table[i + 1], Is.EqualTo(forecaster.At(i * ForecastTable.Step, 0)).Within(1e-12), "point " + i);
        }

        [TestCase("quadratic")]
        [TestCase("process")]
        public void Fill_WeightsSharedByJoints_GivesTheSameTableAsSeparateWeights(string name)
        {
            var shared = New(name);
            foreach (var seed in new[] { 1, 2, 1, 3 })
                foreach (var position in new Func<double, double>[] { Math.Sin, Math.Cos, t => 3 - t })
                {
                    var motion = Motion(seed, shared.Samples, position);
                    Assert.That(Table(shared, motion), Is.EqualTo(Table(New(name), motion)).Within(1e-12), "seed " + seed);
                }
        }

        // The paper's degree is lower until there are enough samples; a Gaussian process needs all of them.
        [TestCase("quadratic", 2, true)]
        [TestCase("quadratic", 1, false)]
        [TestCase("process", 4, false)]
        [TestCase("process", 5, true)]
        public void Solve_FewSamples_SucceedsFromTheMinimumCountOfItsWeights(string name, int count, bool expected)
        {
            Assert.That(new LinearForecaster(New(name)).Solve(Motion(seed: 1, count)), Is.EqualTo(expected));
        }

        static PositionWeights New(string name) => name == "process" ? (PositionWeights)new GaussianProcess() : new PolynomialWeights(2, 4);

        static double[] Table(PositionWeights weights, MotionState motion)
        {
            var (forecaster, table) = (new LinearForecaster(weights, stopsAtReversal: true), new double[ForecastTable.Points]);
            Assert.That(forecaster.Solve(motion));
            forecaster.Fill(table, 0, table.Length, components: 1);
            return table;
        }

        // Samples at random intervals of 10 to 90 ms.
        static MotionState Motion(int seed, int count, Func<double, double> position = null)
        {
            var (random, time) = (new Random(seed), 5.0);
            var (times, positions) = (new double[count], new double[count]);
            for (var i = 0; i < count; i++)
            {
                times[i] = time += 0.01 + 0.08 * random.NextDouble();
                positions[i] = position?.Invoke(time) ?? random.NextDouble();
            }
            return TestPredictors.Motion(times, positions);
        }
    }
}
