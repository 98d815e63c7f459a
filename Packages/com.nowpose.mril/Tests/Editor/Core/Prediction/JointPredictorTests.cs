using System;
using System.Linq;
using Nowpose.Prediction;
using NUnit.Framework;
using static Nowpose.Tests.Core.Prediction.TestPredictors;

namespace Nowpose.Tests.Core.Prediction
{
    public class JointPredictorTests
    {
        static readonly double[] UnevenTimes = { 0.013, 0.05, 0.112, 0.149, 0.21, 0.247, 0.301 };

        static readonly string[] Names = Predictors.Names.ToArray();

        [Test]
        public void Add_OlderThanTheHistory_IsRefused()
        {
            var predictor = Polynomial(1, 1);
            for (var k = 1; k <= 3; k++) predictor.Add(k, k);

            Assert.That(predictor.Add(0, 50), Is.EqualTo(DropReason.LateSample));
            Assert.That(predictor.At(4).Position, Is.EqualTo(4).Within(1e-12));
        }

        [TestCase(2.0, DropReason.DuplicateSample)]
        [TestCase(2.0000009, DropReason.DuplicateSample)]
        [TestCase(1.9999991, DropReason.DuplicateSample)]
        [TestCase(1.0000009, DropReason.DuplicateSample)]
        [TestCase(2.0000011, DropReason.None)]
        [TestCase(1.9999989, DropReason.LateSample)]
        public void Add_TimeNearAnother_IsADuplicateOnlyWithinAMicrosecond(double time, DropReason expected)
        {
            var predictor = Polynomial(2, 2);
            predictor.Add(1, 1);
            predictor.Add(2, 2);

            Assert.That(predictor.Add(time, 99), Is.EqualTo(expected));
            if (expected == DropReason.DuplicateSample) Assert.That(predictor.At(3).Position, Is.EqualTo(3).Within(1e-12));
            else Assert.That(predictor.NewestTime, Is.EqualTo(Math.Max(time, 2)));
        }

        [Test]
        public void Add_StampAndOrderDisagree_SortsByOrderAndSolvesByStamp()
        {
            var predictor = Polynomial(1, 1);
            predictor.Add(new JointSample(1.25, 2, order: 1));

            // The newer sample (by order) has an earlier stamp.
            var reason = predictor.Add(new JointSample(1, 0, order: 1.1));

            Assert.That(reason, Is.EqualTo(DropReason.None));
            Assert.That(predictor.Hold, Is.EqualTo(0));
            Assert.That(predictor.NewestTime, Is.EqualTo(1));
            Assert.That(predictor.At(1.5).Position, Is.EqualTo(4).Within(1e-12));
        }

        [Test]
        public void At_NoSample_IsNone()
        {
            var predictor = Polynomial(2, 2);

            Assert.That(predictor.At(1).Kind, Is.EqualTo(PredictionKind.None));
            Assert.That(predictor.At(1).Position, Is.EqualTo(0));
            Assert.That(predictor.Hold, Is.EqualTo(0));
            Assert.That(predictor.NewestTime, Is.EqualTo(double.NegativeInfinity));
        }

        [Test]
        public void Reset_AfterSamples_RestoresTheInitialState()
        {
            var predictor = Polynomial(2, 2).Fed(UnevenTimes, Math.Sin);

            predictor.Reset();
            Assert.That(predictor.At(1).Kind, Is.EqualTo(PredictionKind.None));
            Assert.That(predictor.Hold, Is.EqualTo(0));

            predictor.Add(-5, 3);
            Assert.That(predictor.At(-4).Position, Is.EqualTo(3));
        }

        [Test]
        public void At_AfterAGap_IgnoresEarlierSamples()
        {
            var predictor = Polynomial(2, 2, new PredictionLimits(maximumGap: 0.5)).Fed(new[] { 0, 0.05, 0.1 }, t => t);

            predictor.Add(0.7, 5);
            Assert.That(predictor.At(0.75).Position, Is.EqualTo(5));
            Assert.That(predictor.At(0.75).Kind, Is.EqualTo(PredictionKind.Held));

            predictor.Add(0.75, 6);
            Assert.That(predictor.At(0.8).Position, Is.EqualTo(7).Within(1e-12));
        }

        [Test]
        public void At_GapClosedByALateSample_UsesTheWholeHistoryAgain()
        {
            var predictor = Polynomial(2, 2, new PredictionLimits(maximumGap: 0.5));
            predictor.Add(0, 0);
            predictor.Add(0.8, 0.64);

            predictor.Add(0.4, 0.16);
            predictor.Add(0.9, 0.81);

            Assert.That(predictor.At(1).Position, Is.EqualTo(1).Within(1e-12));
        }

        [TestCase(0.31, 0.31, PredictionKind.Predicted)]
        [TestCase(0.5, 0.5, PredictionKind.Predicted)]
        [TestCase(0.51, 0.5, PredictionKind.Held)]
        [TestCase(1e9, 0.5, PredictionKind.Held)]
        [TestCase(0.2, 0.2, PredictionKind.Interpolated)]
        [TestCase(0.15, 0.15, PredictionKind.Interpolated)]
        public void At_BeforeAndBeyondTheHorizonCap_HoldsTheValueAtTheCap(double time, double expected, PredictionKind kind)
        {
            var predictor = Polynomial(2, 2, new PredictionLimits()).Fed(new[] { 0.1, 0.15, 0.2 }, t => t);

            Assert.That(predictor.At(time).Position, Is.EqualTo(expected).Within(1e-12));
            Assert.That(predictor.At(time).Kind, Is.EqualTo(kind));
        }

        [TestCase(0.35, 3, 1.0)]
        [TestCase(0.35, -3, -0.5)]
        [TestCase(0.24, 3, 0.72)]
        public void At_BeyondTheJointLimits_IsClamped(double time, double speed, double expected)
        {
            var predictor = Polynomial(1, 1, new PredictionLimits(lower: -0.5, upper: 1)).Fed(new[] { 0.1, 0.2 }, t => speed * t);

            Assert.That(predictor.At(time).Position, Is.EqualTo(expected).Within(1e-12));
        }

        [TestCase(0.1, 0.01, PredictionKind.Interpolated)]
        [TestCase(0.09, 0.01, PredictionKind.Held)]
        [TestCase(-0.9, 0.01, PredictionKind.Held)]
        public void At_BeforeTheSection_HoldsItsOldestSample(double time, double expected, PredictionKind kind)
        {
            var predictor = Polynomial(2, 2, new PredictionLimits()).Fed(new[] { 0.1, 0.15, 0.2 }, t => t * t);

            Assert.That(predictor.At(time).Position, Is.EqualTo(expected).Within(1e-12), "0.81 at -0.9 s if it were extrapolated");
            Assert.That(predictor.At(time).Kind, Is.EqualTo(kind));
            var bare = Polynomial(2, 2).Fed(new[] { 0.1, 0.15, 0.2 }, t => t * t);
            Assert.That(bare.At(-0.9).Position, Is.EqualTo(0.81).Within(1e-9), "the bare polynomial, for studies");
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(double.NegativeInfinity)]
        public void At_ExtremeTime_HoldsInsteadOfReturningNaN(double time)
        {
            var predictor = Polynomial(2, 2).Fed(UnevenTimes, Math.Sin);

            Assert.That(predictor.At(time).Position, Is.EqualTo(predictor.Hold));
            Assert.That(predictor.At(time).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void At_OverflowingSamples_HoldsInsteadOfReturningNaN()
        {
            var predictor = Polynomial(3, 3);
            for (var i = 0; i < 4; i++) predictor.Add(i * 0.05, i % 2 == 0 ? double.MaxValue : -double.MaxValue);

            Assert.That(predictor.At(0.3).Position, Is.EqualTo(predictor.Hold));
            Assert.That(predictor.At(0.3).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void At_Hold_IsTheNewestSampleAtAnyTime()
        {
            var predictor = Predictors.Create("hold", new PredictionLimits());
            predictor.Add(1, 10);
            predictor.Add(2, 20);

            foreach (var time in new[] { 0.0, 2, 2.1, 99 })
            {
                Assert.That(predictor.At(time).Position, Is.EqualTo(20));
                Assert.That(predictor.At(time).Kind, Is.EqualTo(PredictionKind.Held));
            }
            Assert.That(predictor.NewestTime, Is.EqualTo(2));
        }

        [Test]
        public void Add_OlderSampleToHold_IsIgnored()
        {
            var predictor = Predictors.Create("hold", new PredictionLimits());
            predictor.Add(2, 20);

            Assert.That(predictor.Add(1, 10), Is.EqualTo(DropReason.LateSample));
            Assert.That(predictor.Add(2, 30), Is.EqualTo(DropReason.DuplicateSample));
            Assert.That(predictor.Hold, Is.EqualTo(20));
        }

        [Test]
        public void At_HoldBeyondTheJointLimits_IsClamped()
        {
            var predictor = Predictors.Create("hold", new PredictionLimits(lower: 0, upper: 5));
            predictor.Add(2, 20);

            Assert.That(predictor.At(2).Position, Is.EqualTo(5));
        }

        // After each sample, one of two predictors is also asked for positions at random times, in two orders. Both predictors must show the same
        // positions.
        [TestCaseSource(nameof(Names))]
        public void At_AnyTimesInAnyOrder_DoesNotChangeTheState(string name)
        {
            const int seed = 12;
            var random = new Random(seed);
            var limits = new PredictionLimits(velocity: 2, acceleration: 20, jerk: 300);
            DisplayedJoint quiet = new DisplayedJoint(Predictors.Create(name, limits, 0.01)), asked = new DisplayedJoint(Predictors.Create(name, limits, 0.01));
            for (var k = 0; k < 400; k++)
            {
                var sample = new JointSample(k * 0.05 + 0.004 * random.NextDouble(), Math.Sin(3 * k * 0.05), k * 0.05);
                Assert.That(asked.Add(sample), Is.EqualTo(quiet.Add(sample)), "seed " + seed);
                var moments = Enumerable.Range(0, 6).Select(_ => k * 0.05 - 0.3 + 0.8 * random.NextDouble()).ToArray();
                var once = moments.Select(t => (asked.Predictor.At(t), asked.Predictor.DeviationAt(t))).ToArray();
                Assert.That(moments.Reverse().Select(t => (asked.Predictor.At(t), asked.Predictor.DeviationAt(t))).Reverse(), Is.EqualTo(once), "seed " + seed);
                for (var t = k * 0.05 + 0.1; t < k * 0.05 + 0.15; t += 1 / 60.0)
                    Assert.That(asked.Show(t), Is.EqualTo(quiet.Show(t)), "seed " + seed + ", sample " + k);
                Assert.That(asked.Predictor.Horizon, Is.EqualTo(quiet.Predictor.Horizon));
            }
        }

        [TestCase(0.06)]
        [TestCase(0.18)]
        public void Horizon_DisplayTimesReported_IsTheirMeanTimeAheadOfTheNewestSample(double ahead)
        {
            var predictor = Predictors.Create("adaptive", PredictionLimits.Unlimited);
            // Frames continue until the next sample arrives, so the mean horizon is half an interval longer than at the arrival of a sample.
            for (var k = 0; k < 100; k++) predictor.Add(new JointSample(k * 0.05, Math.Sin(k * 0.05)), (k + 0.5) * 0.05 + ahead - 0.05);

            Assert.That(predictor.Horizon, Is.EqualTo(ahead).Within(1e-3));
        }

        [Test]
        public void Horizon_NothingIsDisplayed_IsUnchanged()
        {
            var predictor = Predictors.Create("adaptive", PredictionLimits.Unlimited);
            var before = predictor.Horizon;
            for (var k = 0; k < 100; k++) predictor.Add(k * 0.05, Math.Sin(k * 0.05));

            Assert.That(predictor.Horizon, Is.EqualTo(before));
        }

        [TestCase(double.NaN, 0, 0)]
        [TestCase(0, double.NaN, 0)]
        [TestCase(0, 0, double.PositiveInfinity)]
        public void Sample_NotFinite_IsRefused(double time, double position, double order)
        {
            Assert.Throws<ArgumentException>(() => new JointSample(time, position, order).ToString());
        }
    }
}
