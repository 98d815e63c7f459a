using System;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class TemplateForecasterTests
    {
        const double MatchInterval = 0.035;

        const int Seed = 77;
        const double Ahead = 0.12;

        static readonly SevenPhaseProfile There = new SevenPhaseProfile(300, 900, 5000, 60_000);
        static readonly SevenPhaseProfile Back = new SevenPhaseProfile(-300, 600, 3000, 30_000);

        // Period of the motion, s. It is not a multiple of the sampling interval or of the grid step.
        const double Cycle = 2.7183;

        [TestCase(0.010)]
        [TestCase(0.020)]
        [TestCase(0.050)]
        [TestCase(0.0333)]
        public void At_RepeatingMotion_IsPredictedFromTheSecondCycle(double interval)
        {
            Assert.That(RmsError(interval, 3 * Cycle, 6 * Cycle, 0), Is.LessThan(0.03 * RmsOfHold(interval, 3 * Cycle, 6 * Cycle)));
        }

        // The position is in mm, and the noise is that of a tracker.
        [TestCase(0.010, 0.5)]
        [TestCase(0.020, 1)]
        [TestCase(0.050, 2)]
        [TestCase(0.100, 2)]
        public void At_RepeatingMotionWithNoise_IsPredicted(double interval, double noise)
        {
            var random = new Random(Seed);
            var predictor = Alone();
            int predicted = 0, count = 0;
            for (var i = 0; i * interval < 18 * Cycle; i++)
            {
                predictor.Add(i * interval, Position(i * interval) + noise * (2 * random.NextDouble() - 1));
                if (i * interval < 14 * Cycle) continue;
                if (predictor.At(i * interval + Ahead).Kind == PredictionKind.Predicted) predicted++;
                count++;
            }

            Assert.That(predicted, Is.GreaterThan(0.9 * count), "seed " + Seed);
        }

        // In a dwell that is longer than the compared motion, all parts of the history at rest are equal.
        [TestCase(0.020)]
        [TestCase(0.050)]
        [TestCase(0.0333)]
        public void At_EndOfALongDwell_PredictsTheStartOfTheNextMove(double interval)
        {
            const double dwell = 2;
            var predictor = Alone();
            double squares = 0, hold = 0;
            for (var i = 0; i * interval < 6 * (Cycle + dwell); i++)
            {
                var t = i * interval;
                predictor.Add(t, Dwelling(t));
                if (t < 3 * (Cycle + dwell) || Dwelling(t) != Dwelling(t - 1)) continue;
                squares += Math.Pow(predictor.At(t + Ahead).Position - Dwelling(t + Ahead), 2);
                hold += Math.Pow(Dwelling(t) - Dwelling(t + Ahead), 2);
            }

            Assert.That(hold, Is.GreaterThan(1));
            Assert.That(Math.Sqrt(squares / hold), Is.LessThan(0.05));

            double Dwelling(double t) => Position(Math.Min(t % (Cycle + dwell), Cycle));
        }

        // With these intervals, the number of compared lags is largest. The product compares objects with their history every 0.07 s.
        [Test]
        public void Add_LongestHistory_MotionIsStillPredicted(
            [Values(0.0201, 0.0301, 0.0334, 0.0501, 0.0601, 0.1001)] double interval, [Values(MatchInterval, 0.07)] double matchInterval)
        {
            var predictor = TestPredictors.Of(new TemplateForecaster(new MotionHistory(1), matchInterval));

            for (var t = 0.0; t < 130; t += interval) predictor.Add(t, Position(t));

            Assert.That(predictor.At(predictor.NewestTime + Ahead).Kind, Is.EqualTo(PredictionKind.Predicted));
        }

        [Test]
        public void At_LostSamples_HardlyIncreaseTheError()
        {
            Assert.That(RmsError(0.05, 3 * Cycle, 6 * Cycle, 0.03), Is.LessThan(0.08 * RmsOfHold(0.05, 3 * Cycle, 6 * Cycle)), "seed " + Seed);
        }

        [Test]
        public void At_FirstCycle_IsNotPredicted()
        {
            var predictor = Alone();
            for (var t = 0.0; t < 0.6; t += 0.05)
            {
                predictor.Add(t, Position(t));

                Assert.That(predictor.At(t + Ahead).Kind, Is.EqualTo(PredictionKind.Held));
            }
        }

        [Test]
        public void At_OtherMoves_AreNotPredicted()
        {
            var random = new Random(Seed);
            var predictor = Alone();
            double time = 0, place = 0;
            var direction = 1;
            int predicted = 0, count = 0;
            for (var move = 0; move < 12; move++, direction = -direction)
            {
                var stroke = direction * (100 + 400 * random.NextDouble());
                var profile = new SevenPhaseProfile(stroke, 500 + 500 * random.NextDouble(), 2000 + 3000 * random.NextDouble(), 50_000);
                var end = time + profile.Duration;
                for (var start = time; time < end; time += 0.05)
                {
                    predictor.Add(time, place + profile.PositionAt(time - start));
                    // The first samples of two moves can be similar.
                    if (time - start < 0.2 || move == 0) continue;
                    if (predictor.At(time + Ahead).Kind == PredictionKind.Predicted) predicted++;
                    count++;
                }
                place += stroke;
            }

            Assert.That(predicted, Is.LessThan(0.1 * count), "seed " + Seed);
        }

        [TestCase(1.0)]
        [TestCase(2.5)]
        public void Add_PauseBeyondTheMaximumGap_DiscardsTheCycles(double pause)
        {
            var predictor = Fed(new PredictionLimits(maximumGap: 0.5), 0.05, 3 * Cycle);
            Assert.That(predictor.At(predictor.NewestTime + Ahead).Kind, Is.EqualTo(PredictionKind.Predicted));

            predictor.Add(predictor.NewestTime + pause, 0);

            Assert.That(predictor.At(predictor.NewestTime + Ahead).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void Add_OvertakenSample_IsIgnored()
        {
            var predictor = Fed(PredictionLimits.Unlimited, 0.05, 3 * Cycle);
            var before = predictor.At(predictor.NewestTime + Ahead).Position;

            Assert.That(predictor.Add(predictor.NewestTime - 0.02, 5), Is.EqualTo(DropReason.LateSample));
            Assert.That(predictor.At(predictor.NewestTime + Ahead).Position, Is.EqualTo(before));
        }

        [Test]
        public void Add_CycleChanges_NewCycleIsPredicted()
        {
            var predictor = Fed(PredictionLimits.Unlimited, 0.05, 3 * Cycle);
            var start = predictor.NewestTime;
            for (var i = 1; i * 0.02 < 3 * Cycle; i++) predictor.Add(start + i * 0.02, Position(start + i * 0.02));

            var t = predictor.NewestTime + Ahead;
            Assert.That(predictor.At(t).Position, Is.EqualTo(Position(t)).Within(1));
        }

        [Test]
        public void At_HistoryFull_CycleIsPredicted()
        {
            var predictor = Fed(PredictionLimits.Unlimited, 0.02, 150);
            var t = predictor.NewestTime + Ahead;

            Assert.That(predictor.At(t).Position, Is.EqualTo(Position(t)).Within(1));
        }

        [Test]
        public void At_ExtremeSamples_IsFinite()
        {
            var random = new Random(Seed);
            var values = new[] { 0, 1, 1e300, -1e300, 1e49, double.Epsilon, 3, 3, 3 };
            var predictor = Alone();
            for (var k = 0; k < 2000; k++)
            {
                predictor.Add(k * 0.05, values[random.Next(values.Length)]);

                Assert.That(double.IsFinite(predictor.At(k * 0.05 + Ahead).Position), "seed " + Seed + ", sample " + k);
            }
        }

        static JointPredictor Alone(PredictionLimits limits = null) =>
            TestPredictors.Of(new TemplateForecaster(new MotionHistory(1), MatchInterval), limits);

        static double Position(double t)
        {
            var inCycle = t % Cycle;
            return inCycle < 1.2 ? There.PositionAt(inCycle - 0.3) : 300 + Back.PositionAt(inCycle - 1.2);
        }

        static JointPredictor Fed(PredictionLimits limits, double interval, double seconds)
        {
            var predictor = Alone(limits);
            for (var i = 0; i * interval < seconds; i++) predictor.Add(i * interval, Position(i * interval));
            return predictor;
        }

        static double RmsError(double interval, double from, double to, double loss)
        {
            var random = new Random(Seed);
            var predictor = Alone();
            double squares = 0, count = 0;
            for (var i = 0; i * interval < to; i++)
            {
                var t = i * interval;
                if (random.NextDouble() < loss) continue;
                predictor.Add(t, Position(t));
                if (t < from) continue;
                squares += Math.Pow(predictor.At(t + Ahead).Position - Position(t + Ahead), 2);
                count++;
            }
            return Math.Sqrt(squares / count);
        }

        static double RmsOfHold(double interval, double from, double to)
        {
            double squares = 0, count = 0;
            for (var t = from; t < to; t += interval, count++) squares += Math.Pow(Position(t) - Position(t + Ahead), 2);
            return Math.Sqrt(squares / count);
        }
    }
}
