using System;
using System.Linq;
using MathNet.Numerics;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class PolynomialPredictorTests
    {
        static readonly double[] UnevenTimes = { 0.013, 0.05, 0.112, 0.149, 0.21, 0.247, 0.301 };

        static PolynomialPredictor Unlimited(int degree, int history) =>
            new PolynomialPredictor(degree, history, PredictionLimits.Unlimited);

        static void Feed(IJointPredictor predictor, double[] times, Func<double, double> motion)
        {
            foreach (var t in times) predictor.Add(new JointSample(t, motion(t)));
        }

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
            var predictor = Unlimited(degree, history);
            Feed(predictor, UnevenTimes, t => Motion(degree, t));

            foreach (var t in new[] { 0.15, 0.29, 0.301, 0.35, 0.5, 1.0 })
                Assert.That(predictor.At(t).Position, Is.EqualTo(Motion(degree, t)).Within(1e-12), "at " + t);
        }

        [TestCase(1, 1)]
        [TestCase(2, 2)]
        [TestCase(3, 3)]
        public void At_MotionOfAHigherDegree_IsMissed(int degree, int history)
        {
            var predictor = Unlimited(degree, history);
            Feed(predictor, UnevenTimes, t => Math.Pow(t, degree + 1));

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
                var predictor = Unlimited(degree, history);
                predictor.Add(new JointSample(-1, 100));
                for (var i = 0; i < times.Length; i++) predictor.Add(new JointSample(times[i], positions[i]));

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
                    var predictor = Unlimited(degree, history);
                    for (var i = 0; i < times.Length; i++) predictor.Add(new JointSample(times[i], positions[i]));
                    var asked = times.Last() + 0.1;

                    // Times from the newest: subtraction of doubles this near is exact, and keeps the fractions short.
                    var expected = ExactPolynomial.ValueAt(
                        asked - times.Last(), degree, times.Select(t => t - times.Last()).ToArray(), positions);

                    Assert.That(predictor.At(asked).Position, Is.EqualTo(expected).Within(1e-9 * Math.Abs(expected)),
                        "seed " + seed + ", epoch " + epoch);
                }
        }

        [Test]
        public void Add_AnyOrder_EndsLikeInOrder()
        {
            for (var seed = 1; seed <= 100; seed++)
            {
                var random = new Random(seed);
                var times = Times(random, 12, 0.02, 0.08);
                var inOrder = Unlimited(2, 4);
                var shuffled = Unlimited(2, 4);
                Feed(inOrder, times, Math.Sin);
                Feed(shuffled, times.OrderBy(_ => random.Next()).ToArray(), Math.Sin);

                Assert.That(shuffled.At(times.Last() + 0.1).Position,
                    Is.EqualTo(inOrder.At(times.Last() + 0.1).Position), "seed " + seed);
                Assert.That(shuffled.Hold, Is.EqualTo(Math.Sin(times.Last())), "seed " + seed);
                Assert.That(shuffled.NewestTime, Is.EqualTo(times.Last()), "seed " + seed);
            }
        }

        [Test]
        public void Add_LateSample_IsPutInItsPlace()
        {
            var predictor = Unlimited(1, 1);
            predictor.Add(new JointSample(0, 0));
            predictor.Add(new JointSample(2, 2));

            var outcome = predictor.Add(new JointSample(1, 5));

            Assert.That(outcome, Is.EqualTo(SampleOutcome.Late));
            Assert.That(predictor.At(3).Position, Is.EqualTo(-1).Within(1e-12));
            Assert.That(predictor.Hold, Is.EqualTo(2));
        }

        [Test]
        public void Add_OlderThanAllItNeeds_IsRefused()
        {
            var predictor = Unlimited(1, 1);
            predictor.Add(new JointSample(1, 1));
            predictor.Add(new JointSample(2, 2));

            Assert.That(predictor.Add(new JointSample(0, 50)), Is.EqualTo(SampleOutcome.TooOld));
            Assert.That(predictor.At(3).Position, Is.EqualTo(3).Within(1e-12));
        }

        [TestCase(2.0, SampleOutcome.Duplicate)]
        [TestCase(2.0000009, SampleOutcome.Duplicate)]
        [TestCase(1.9999991, SampleOutcome.Duplicate)]
        [TestCase(1.0000009, SampleOutcome.Duplicate)]
        [TestCase(2.0000011, SampleOutcome.Accepted)]
        [TestCase(1.9999989, SampleOutcome.Late)]
        public void Add_SameMoment_IsRefusedWithinAMicrosecond(double time, SampleOutcome expected)
        {
            var predictor = Unlimited(2, 2);
            predictor.Add(new JointSample(1, 1));
            predictor.Add(new JointSample(2, 2));

            Assert.That(predictor.Add(new JointSample(time, 99)), Is.EqualTo(expected));
            if (expected == SampleOutcome.Duplicate) Assert.That(predictor.At(3).Position, Is.EqualTo(3).Within(1e-12));
        }

        [Test]
        public void Add_StampInError_SortsByOrderAndSolvesByStamp()
        {
            var predictor = Unlimited(1, 1);
            predictor.Add(new JointSample(1.25, 2, order: 1));

            // The newer sample is told an earlier time.
            var outcome = predictor.Add(new JointSample(1, 0, order: 1.1));

            Assert.That(outcome, Is.EqualTo(SampleOutcome.Accepted));
            Assert.That(predictor.Hold, Is.EqualTo(0));
            Assert.That(predictor.NewestTime, Is.EqualTo(1));
            Assert.That(predictor.At(1.5).Position, Is.EqualTo(4).Within(1e-12));
        }

        [Test]
        public void At_FewSamples_UsesTheHighestDegreeTheyAllow()
        {
            var predictor = Unlimited(3, 5);
            // The samples are t²: from three on it is exact.
            var expected = new[] { 0, 2, 9, 16.0 };

            for (var i = 0; i < expected.Length; i++)
            {
                predictor.Add(new JointSample(i, i * i));
                var answer = predictor.At(i + 1);
                Assert.That(answer.Position, Is.EqualTo(expected[i]).Within(1e-12), i + 1 + " samples");
                Assert.That(answer.Kind, Is.EqualTo(i == 0 ? PredictionKind.Held : PredictionKind.Predicted), i + 1 + " samples");
            }
        }

        [Test]
        public void At_NoSample_IsNone()
        {
            var predictor = Unlimited(2, 2);

            Assert.That(predictor.At(1).Kind, Is.EqualTo(PredictionKind.None));
            Assert.That(predictor.At(1).Position, Is.EqualTo(0));
            Assert.That(predictor.Hold, Is.EqualTo(0));
            Assert.That(predictor.NewestTime, Is.EqualTo(double.NegativeInfinity));
        }

        [Test]
        public void Reset_AfterSamples_IsLikeNew()
        {
            var predictor = Unlimited(2, 2);
            Feed(predictor, UnevenTimes, Math.Sin);

            predictor.Reset();
            Assert.That(predictor.At(1).Kind, Is.EqualTo(PredictionKind.None));

            predictor.Add(new JointSample(-5, 3));
            Assert.That(predictor.At(-4).Position, Is.EqualTo(3));
        }

        [Test]
        public void At_AfterAGap_ForgetsWhatWasBefore()
        {
            var predictor = new PolynomialPredictor(2, 2, new PredictionLimits(maximumGap: 0.5));
            Feed(predictor, new[] { 0, 0.05, 0.1 }, t => t);

            predictor.Add(new JointSample(0.7, 5));
            Assert.That(predictor.At(0.75).Position, Is.EqualTo(5));
            Assert.That(predictor.At(0.75).Kind, Is.EqualTo(PredictionKind.Held));

            predictor.Add(new JointSample(0.75, 6));
            Assert.That(predictor.At(0.8).Position, Is.EqualTo(7).Within(1e-12));
        }

        [Test]
        public void At_GapClosedByALateSample_UsesTheWholeHistoryAgain()
        {
            var predictor = new PolynomialPredictor(2, 2, new PredictionLimits(maximumGap: 0.5));
            predictor.Add(new JointSample(0, 0));
            predictor.Add(new JointSample(0.8, 0.64));

            predictor.Add(new JointSample(0.4, 0.16));

            Assert.That(predictor.At(1).Position, Is.EqualTo(1).Within(1e-12));
        }

        [TestCase(0.31, 0.31, PredictionKind.Predicted)]
        [TestCase(0.5, 0.5, PredictionKind.Predicted)]
        [TestCase(0.51, 0.5, PredictionKind.Held)]
        [TestCase(1e9, 0.5, PredictionKind.Held)]
        [TestCase(0.2, 0.2, PredictionKind.Interpolated)]
        [TestCase(0.15, 0.15, PredictionKind.Interpolated)]
        public void At_AroundTheHorizonCap_HoldsTheValueThere(double time, double expected, PredictionKind kind)
        {
            var predictor = new PolynomialPredictor(2, 2, new PredictionLimits());
            Feed(predictor, new[] { 0.1, 0.15, 0.2 }, t => t);

            Assert.That(predictor.At(time).Position, Is.EqualTo(expected).Within(1e-12));
            Assert.That(predictor.At(time).Kind, Is.EqualTo(kind));
        }

        [TestCase(0.35, 3, 1.0)]
        [TestCase(0.35, -3, -0.5)]
        [TestCase(0.24, 3, 0.72)]
        public void At_BeyondTheJointLimits_StopsAtThem(double time, double speed, double expected)
        {
            var predictor = new PolynomialPredictor(1, 1, new PredictionLimits(lower: -0.5, upper: 1));
            Feed(predictor, new[] { 0.1, 0.2 }, t => speed * t);

            Assert.That(predictor.At(time).Position, Is.EqualTo(expected).Within(1e-12));
        }

        [TestCase(0.1, 0.01, PredictionKind.Interpolated)]
        [TestCase(0.09, 0.01, PredictionKind.Held)]
        [TestCase(-0.9, 0.01, PredictionKind.Held)]
        public void At_BeforeTheSection_HoldsItsOldestSample(double time, double expected, PredictionKind kind)
        {
            var predictor = new PolynomialPredictor(2, 2, new PredictionLimits());
            Feed(predictor, new[] { 0.1, 0.15, 0.2 }, t => t * t);

            Assert.That(predictor.At(time).Position, Is.EqualTo(expected).Within(1e-12), "0.81 at -0.9 s if it were extrapolated");
            Assert.That(predictor.At(time).Kind, Is.EqualTo(kind));
            Assert.That(UnlimitedAt(-0.9), Is.EqualTo(0.81).Within(1e-9), "the bare polynomial, for studies");
        }

        static double UnlimitedAt(double time)
        {
            var predictor = Unlimited(2, 2);
            Feed(predictor, new[] { 0.1, 0.15, 0.2 }, t => t * t);
            return predictor.At(time).Position;
        }

        [TestCase(2, 2)]
        [TestCase(3, 3)]
        [TestCase(2, 4)]
        public void At_CoincidentStamps_FallsBackToALowerDegree(int degree, int history)
        {
            var predictor = Unlimited(degree, history);
            for (var i = 0; i <= history; i++) predictor.Add(new JointSample(i < history ? 0.1 : 0.2, i < history ? 1 : 2, order: i));

            Assert.That(predictor.At(0.3).Position, Is.EqualTo(3).Within(1e-9));
        }

        [Test]
        public void At_AllStampsCoincide_HoldsTheNewest()
        {
            var predictor = Unlimited(2, 2);
            for (var i = 0; i < 3; i++) predictor.Add(new JointSample(0.1, i, order: i));

            Assert.That(predictor.At(0.3).Position, Is.EqualTo(2));
            Assert.That(predictor.At(0.3).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(double.NegativeInfinity)]
        public void At_AbsurdTime_HoldsInsteadOfHandingOutNaN(double time)
        {
            var predictor = Unlimited(2, 2);
            Feed(predictor, UnevenTimes, Math.Sin);

            Assert.That(predictor.At(time).Position, Is.EqualTo(predictor.Hold));
            Assert.That(predictor.At(time).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void At_OverflowingSamples_HoldsInsteadOfHandingOutNaN()
        {
            var predictor = Unlimited(3, 3);
            for (var i = 0; i < 4; i++) predictor.Add(new JointSample(i * 0.05, i % 2 == 0 ? double.MaxValue : -double.MaxValue));

            Assert.That(predictor.At(0.3).Position, Is.EqualTo(predictor.Hold));
            Assert.That(predictor.At(0.3).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [TestCase(0, 1)]
        [TestCase(4, 4)]
        [TestCase(2, 1)]
        [TestCase(2, 101)]
        public void Predictor_ImpossibleDegreeOrHistory_IsRefused(int degree, int history)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => Unlimited(degree, history));
        }

        [TestCase(double.NaN, 0, 0)]
        [TestCase(0, double.NaN, 0)]
        [TestCase(0, 0, double.PositiveInfinity)]
        public void Sample_NotFinite_IsRefused(double time, double position, double order)
        {
            Assert.Throws<ArgumentException>(() => new JointSample(time, position, order).ToString());
        }

        static double[] Times(Random random, int count, double shortest, double longest)
        {
            var times = new double[count];
            for (var i = 1; i < count; i++) times[i] = times[i - 1] + shortest + (longest - shortest) * random.NextDouble();
            return times;
        }

        /// <summary>Pairs of stamps a cluster's width apart, the pairs 50 ms from each other.</summary>
        static double[] Clustered(Random random, int count, double cluster)
        {
            var times = new double[count];
            for (var i = 0; i < count; i++) times[i] = i / 2 * 0.05 + (i % 2 + 0.1 * random.NextDouble()) * cluster;
            return times;
        }
    }
}
