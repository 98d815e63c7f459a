using System;
using System.Linq;
using MathNet.Numerics;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class PolynomialForecasterTests
    {
        static readonly double[] UnevenTimes = { 0.013, 0.05, 0.112, 0.149, 0.21, 0.247, 0.301 };

        static double Motion(int degree, double t)
        {
            var coefficients = new[] { 1.25, -2, 7, -11 };
            var value = 0.0;
            for (var i = degree; i >= 0; i--) value = value * t + coefficients[i];
            return value;
        }

        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(3, 3)]
        [TestCase(1, 3)]
        [TestCase(2, 3)]
        [TestCase(2, 4)]
        [TestCase(3, 5)]
        public void At_MotionOfItsDegree_IsPredictedExactly(int degree, int history)
        {
            var predictor = TestPredictors.Polynomial(degree, history).Fed(UnevenTimes, t => Motion(degree, t));

            foreach (var t in new[] { 0.15, 0.29, 0.301, 0.35, 0.5, 1.0 })
                Assert.That(predictor.At(t).Position, Is.EqualTo(Motion(degree, t)).Within(1e-12), "at " + t);
        }

        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(3, 3)]
        public void At_MotionOfAHigherDegree_HasAnError(int degree, int history)
        {
            var predictor = TestPredictors.Polynomial(degree, history).Fed(UnevenTimes, t => Math.Pow(t, degree + 1));

            Assert.That(Math.Abs(predictor.At(0.5).Position - Math.Pow(0.5, degree + 1)), Is.GreaterThan(1e-3));
        }

        [TestCase(2, 2)]
        [TestCase(3, 3)]
        [TestCase(1, 2)]
        [TestCase(2, 3)]
        [TestCase(2, 4)]
        [TestCase(3, 6)]
        public void At_AnyPositions_AgreesWithAnotherLibrary(int degree, int history)
        {
            for (var seed = 1; seed <= 50; seed++)
            {
                var random = new Random(seed);
                var times = Times(random, history + 1, 0.02, 0.08);
                var positions = times.Select(_ => random.NextDouble() * 6 - 3).ToArray();
                var predictor = TestPredictors.Polynomial(degree, history);
                predictor.Add(-1, 100);
                for (var i = 0; i < times.Length; i++) predictor.Add(times[i], positions[i]);

                var expected = Polynomial.Evaluate(times.Last() + 0.1, Fit.Polynomial(times, positions, degree));

                Assert.That(predictor.At(times.Last() + 0.1).Position,
                    Is.EqualTo(expected).Within(1e-9 * (1 + Math.Abs(expected))), "seed " + seed);
            }
        }

        [TestCase(1, 1, 1e-3)]
        [TestCase(2, 2, 1e-3)]
        [TestCase(3, 3, 1e-3)]
        [TestCase(2, 3, 1e-3)]
        [TestCase(2, 4, 1e-3)]
        [TestCase(2, 2, 1e-5)]
        [TestCase(3, 3, 1e-5)]
        [TestCase(2, 3, 1e-5)]
        [TestCase(2, 4, 1e-5)]
        public void At_ClusteredStamps_AgreesWithExactArithmetic(int degree, int history, double cluster)
        {
            foreach (var epoch in new[] { 0.0, 1e3, 1e6 })
                for (var seed = 1; seed <= 20; seed++)
                {
                    var random = new Random(seed);
                    var times = Clustered(random, history + 1, cluster).Select(t => epoch + t).ToArray();
                    var positions = times.Select(t => Math.Sin(3 * (t - epoch)) + 1e-4 * random.NextDouble()).ToArray();
                    var predictor = TestPredictors.Polynomial(degree, history);
                    for (var i = 0; i < times.Length; i++) predictor.Add(times[i], positions[i]);
                    var asked = times.Last() + 0.1;

                    // Times are relative to the newest sample: the subtraction of doubles this close is exact, and the fractions are shorter.
                    var expected = ExactPolynomial.ValueAt(
                        asked - times.Last(), degree, times.Select(t => t - times.Last()).ToArray(), positions);

                    Assert.That(predictor.At(asked).Position, Is.EqualTo(expected).Within(1e-9 * Math.Abs(expected)),
                        "seed " + seed + ", epoch " + epoch);
                }
        }

        [Test]
        public void At_FewSamples_UsesTheHighestPossibleDegree()
        {
            var predictor = TestPredictors.Polynomial(3, 5);
            // The samples follow t², so the forecast is exact from the third sample on.
            var expected = new[] { 0, 2, 9, 16.0 };

            for (var i = 0; i < expected.Length; i++)
            {
                predictor.Add(i, i * i);
                var answer = predictor.At(i + 1);
                Assert.That(answer.Position, Is.EqualTo(expected[i]).Within(1e-12), i + 1 + " samples");
                Assert.That(answer.Kind, Is.EqualTo(i == 0 ? PredictionKind.Held : PredictionKind.Predicted), i + 1 + " samples");
            }
        }

        [TestCase(2, 2)]
        [TestCase(3, 3)]
        [TestCase(2, 4)]
        public void At_CoincidentStamps_FallsBackToALowerDegree(int degree, int history)
        {
            var predictor = TestPredictors.Polynomial(degree, history);
            for (var i = 0; i <= history; i++) predictor.Add(new JointSample(i < history ? 0.1 : 0.2, i < history ? 1 : 2, order: i));

            Assert.That(predictor.At(0.3).Position, Is.EqualTo(3).Within(1e-9));
        }

        [Test]
        public void At_AllStampsCoincide_HoldsTheNewest()
        {
            var predictor = TestPredictors.Polynomial(2, 2);
            for (var i = 0; i < 3; i++) predictor.Add(new JointSample(0.1, i, order: i));

            Assert.That(predictor.At(0.3).Position, Is.EqualTo(2));
            Assert.That(predictor.At(0.3).Kind, Is.EqualTo(PredictionKind.Held));
        }

        static double[] Times(Random random, int count, double shortest, double longest)
        {
            var times = new double[count];
            for (var i = 1; i < count; i++) times[i] = times[i - 1] + shortest + (longest - shortest) * random.NextDouble();
            return times;
        }

        /// <summary>Returns pairs of stamps: about <paramref name="cluster"/> (s) between the stamps of a pair, 50 ms between pairs.</summary>
        static double[] Clustered(Random random, int count, double cluster)
        {
            var times = new double[count];
            for (var i = 0; i < count; i++) times[i] = i / 2 * 0.05 + (i % 2 + 0.1 * random.NextDouble()) * cluster;
            return times;
        }
    }
}
