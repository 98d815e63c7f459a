using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class LinearForecasterTests
    {
        static readonly double[] Aheads = { 0, 0.013, 0.05, 0.1, 0.217, 0.5 };

        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(2, 4)]
        [TestCase(3, 3)]
        [TestCase(3, 5)]
        public void At_PolynomialWeights_EqualsThePolynomialForecaster(int degree, int history)
        {
            for (var seed = 1; seed <= 20; seed++)
            {
                var motion = Motion(seed, history + 1);
                var polynomial = new PolynomialForecaster(degree, history);
                var linear = new LinearForecaster(new PolynomialWeights(degree, history));
                Assert.That(polynomial.Solve(motion) && linear.Solve(motion));

                foreach (var ahead in Aheads)
                    Assert.That(linear.At(ahead), Is.EqualTo(polynomial.At(ahead)).Within(1e-9 * (1 + Math.Abs(polynomial.At(ahead)))), "seed " + seed);
            }
        }

        [TestCase("quadratic")]
        [TestCase("process")]
        public void Fill_AnyWeights_EqualsAtForEveryPoint(string name)
        {
            var weights = New(name);
            var forecaster = new LinearForecaster(weights);
            forecaster.Solve(Motion(seed: 1, weights.Samples));
            var table = new double[ForecastTable.Points + 1];
            forecaster.Fill(table, 1, ForecastTable.Points);

            for (var i = 0; i < ForecastTable.Points; i++)
                Assert.That(table[i + 1], Is.EqualTo(forecaster.At(i * ForecastTable.Step)).Within(1e-12), "point " + i);
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

        [Test]
        public void Solve_CoincidingTimes_ReturnsFalseForPolynomials()
        {
            var history = new SampleHistory(4);
            for (var i = 0; i < 4; i++) history.Add(new JointSample(i < 2 ? 0.1 : 0.1 * i, i, order: i));

            Assert.That(new LinearForecaster(new PolynomialWeights(3, 3)).Solve(history), Is.False);
            Assert.That(new LinearForecaster(new PolynomialWeights(2, 3)).Solve(history), Is.True);
        }

        static PositionWeights New(string name) => name == "process" ? (PositionWeights)new GaussianProcess() : new PolynomialWeights(2, 4);

        static double[] Table(PositionWeights weights, MotionState motion)
        {
            var (forecaster, table) = (new LinearForecaster(weights, stopsAtReversal: true), new double[ForecastTable.Points]);
            Assert.That(forecaster.Solve(motion));
            forecaster.Fill(table, 0, table.Length);
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
