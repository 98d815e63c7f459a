using System;
using NUnit.Framework;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class LinearSmootherTests
    {
        [TestCase("quadratic")]
        [TestCase("process")]
        public void Fill_AnyForecaster_EqualsAtForEveryPoint(string name)
        {
            var forecaster = New(name, stopsAtReversal: false);
            forecaster.Solve(Motion(seed: 1, forecaster.UsedSamples));
            var table = new double[ForecastTable.Points + 1];
            forecaster.Fill(table, 1, ForecastTable.Points, components: 1);

            for (var i = 0; i < ForecastTable.Points; i++)
                Assert.That(table[i + 1], Is.EqualTo(forecaster.At(i * ForecastTable.Step, 0)).Within(1e-12), "point " + i);
        }

        [TestCase("quadratic")]
        [TestCase("process")]
        public void Fill_SharedByJoints_GivesTheSameTableAsSeparateForecasters(string name)
        {
            var shared = New(name);
            foreach (var seed in new[] { 1, 2, 1, 3 })
                foreach (var position in new Func<double, double>[] { Math.Sin, Math.Cos, t => 3 - t })
                {
                    var motion = Motion(seed, shared.UsedSamples, position);
                    Assert.That(Table(shared, motion), Is.EqualTo(Table(New(name), motion)).Within(1e-12), "seed " + seed);
                }
        }

        // The paper's degree is lower until there are enough samples; a Gaussian process needs all of them.
        [TestCase("quadratic", 2, true)]
        [TestCase("quadratic", 1, false)]
        [TestCase("process", 4, false)]
        [TestCase("process", 5, true)]
        public void Solve_FewSamples_SucceedsFromTheMinimumCount(string name, int count, bool expected)
        {
            Assert.That(New(name).Solve(Motion(seed: 1, count)), Is.EqualTo(expected));
        }

        static LinearSmoother New(string name, bool stopsAtReversal = true) => name == "process"
            ? (LinearSmoother)new GaussianProcess(stopsAtReversal) : new PolynomialForecaster(2, 4, stopsAtReversal);

        static double[] Table(LinearSmoother forecaster, MotionState motion)
        {
            var table = new double[ForecastTable.Points];
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
