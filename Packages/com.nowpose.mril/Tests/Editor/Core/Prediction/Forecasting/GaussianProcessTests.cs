using System;
using System.Linq;
using MathNet.Numerics.LinearAlgebra;
using Nowpose.Prediction.Forecasting;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class GaussianProcessTests
    {
        const double LengthScale = 0.6;
        const double Noise = 1e-7;
        const double Level = 1000;
        const double Trend = 1000 / (LengthScale * LengthScale);

        static readonly double[] Aheads = { 0, 0.013, 0.05, 0.1, 0.217, 0.5 };

        [TestCase(0, 0.01, 0.02, 0.03, 0.04)]
        [TestCase(0, 0.05, 0.1, 0.15, 0.2)]
        [TestCase(0, 0.1, 0.2, 0.3, 0.4)]
        [TestCase(0, 0.013, 0.09, 0.1, 0.161)]
        [TestCase(0, 0.2, 0.21, 0.55, 1.3)]
        public void AtAndVarianceAt_AnyIntervals_EqualTheTextbookFormula(params double[] times)
        {
            const double epoch = 5;
            for (var seed = 1; seed <= 10; seed++)
            {
                var random = new Random(seed);
                var positions = times.Select(t => Math.Sin(4 * t + seed) + 0.01 * random.NextDouble()).ToArray();
                var process = new GaussianProcess();
                Assert.That(process.Solve(TestPredictors.Motion(times.Select(t => epoch + t).ToArray(), positions)));

                // Rasmussen & Williams 2006, Eqs. 2.25 and 2.26. The variance of the motion is estimated from the samples.
                var newest = times.Last();
                var k = Matrix<double>.Build.Dense(5, 5, (i, j) => Kernel(times[i] - newest, times[j] - newest) + (i == j ? Noise : 0)).Cholesky();
                var y = Vector<double>.Build.DenseOfEnumerable(positions.Select(p => p - positions.Last()));
                var variance = y * k.Solve(y) / 5;
                foreach (var ahead in Aheads)
                {
                    var star = Vector<double>.Build.Dense(5, i => Kernel(times[i] - newest, ahead));
                    var mean = star * k.Solve(y);
                    var deviation = Math.Sqrt(variance * Math.Max(Kernel(ahead, ahead) - star * k.Solve(star), 0));

                    Assert.That(process.At(ahead, 0), Is.EqualTo(mean).Within(1e-5 * (1 + Math.Abs(mean))), "seed " + seed + ", " + ahead + " s");
                    Assert.That(Math.Sqrt(variance * process.VarianceAt(ahead)), Is.EqualTo(deviation).Within(1e-3 * deviation + 1e-4), "seed " + seed + ", " + ahead + " s");
                }
            }
        }

        [TestCase(0.01)]
        [TestCase(0.05)]
        [TestCase(0.1)]
        public void At_ConstantVelocity_IsExact(double interval)
        {
            var process = new GaussianProcess();
            var times = Enumerable.Range(0, 5).Select(i => i * interval).ToArray();
            process.Solve(TestPredictors.Motion(times, times.Select(t => 3 - t).ToArray()));

            foreach (var ahead in Aheads.Where(a => a <= 0.25)) Assert.That(process.At(ahead, 0), Is.EqualTo(-ahead).Within(1e-4));
        }

        [Test]
        public void Fill_MotionReverses_StopsAtTheReversal()
        {
            var times = Enumerable.Range(0, 5).Select(i => i * 0.05).ToArray();
            var process = new GaussianProcess(stopsAtReversal: true);
            process.Solve(TestPredictors.Motion(times, times.Select(t => 1 - Math.Pow(0.25 - t, 2)).ToArray()));
            var table = new double[ForecastTable.Points];
            process.Fill(table, 0, table.Length, components: 1);

            Assert.That(process.At(0.4, 0), Is.LessThan(0));
            Assert.That(table[1], Is.EqualTo(process.At(ForecastTable.Step, 0)).Within(1e-9));
            Assert.That(table[8], Is.EqualTo(table[4]).And.GreaterThan(0));
        }

        [Test]
        public void Solve_TooFewSamplesOrTooLargeGap_ReturnsFalse()
        {
            var process = new GaussianProcess();

            Assert.That(process.Solve(TestPredictors.Motion(new[] { 0, 0.1, 0.2, 0.3 }, new double[4])), Is.False);
            Assert.That(process.Solve(TestPredictors.Motion(new[] { 0, 0.1, 0.2, 0.3, 100 }, new double[5])), Is.False);
        }

        [Test]
        public void VarianceAt_LongerHorizon_IsLarger()
        {
            var process = new GaussianProcess();
            var times = Enumerable.Range(0, 5).Select(i => i * 0.05).ToArray();
            process.Solve(TestPredictors.Motion(times, times.Select(t => Math.Sin(8 * t)).ToArray()));

            Assert.That(Aheads.Select(process.VarianceAt), Is.Ordered);
            Assert.That(process.VarianceAt(0), Is.LessThan(4e-6));
        }

        // Returns the Matérn kernel of order 7/2 plus the kernel of a random straight line. The Matérn kernel is computed from the general
        // form, Rasmussen & Williams 2006, Eq. 4.16, with p = 3.
        static double Kernel(double a, double b)
        {
            var r = Math.Sqrt(7) * Math.Abs(a - b) / LengthScale;
            double Factorial(int n) => n < 2 ? 1 : n * Factorial(n - 1);
            var sum = 0.0;
            for (var i = 0; i <= 3; i++) sum += Factorial(3 + i) / (Factorial(i) * Factorial(3 - i)) * Math.Pow(2 * r, 3 - i);
            return Math.Exp(-r) * Factorial(3) / Factorial(6) * sum + Level + Trend * a * b;
        }
    }
}
