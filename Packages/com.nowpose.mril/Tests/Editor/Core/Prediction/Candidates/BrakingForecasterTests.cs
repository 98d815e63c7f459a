using System;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class BrakingForecasterTests
    {
        const int Seed = 62;
        const double Ahead = 0.12;

        // Rest before the move, s. It is not a multiple of the sampling interval.
        const double Start = 0.7123;

        // Includes strokes too short to reach the velocity or the acceleration limit.
        [Test]
        public void At_BrakingMove_IsPredictedToItsEnd([Values(500, -500, 150, -60)] double stroke, [Values(0.02, 0.05)] double interval)
        {
            var move = new SevenPhaseProfile(stroke, 1000, 5000, 30_000);
            var predictor = Alone();
            int forecasts = 0, k = 0;
            for (; k * interval < Start + move.Duration; k++)
            {
                predictor.Add(k * interval, 7 + move.PositionAt(k * interval - Start));
                var forecast = predictor.At(k * interval + Ahead);
                if (forecast.Kind == PredictionKind.Held) continue;
                forecasts++;
                var truth = 7 + move.PositionAt(k * interval + Ahead - Start);
                Assert.That(forecast.Position, Is.EqualTo(truth).Within(0.012 * Math.Abs(stroke)), $"{k * interval - Start} s after the start");
            }

            Assert.That(forecasts, Is.GreaterThan(0));
        }

        // The history before the second move contains the end of the first one.
        [Test]
        public void At_MoveAfterAShortDwell_EndsAtRest()
        {
            const double dwell = 0.1, interval = 0.01;
            var move = new SevenPhaseProfile(300, 1000, 5000, 30_000);
            double Position(double t) => move.PositionAt(t - Start) + move.PositionAt(t - Start - move.Duration - dwell);
            var predictor = Alone();
            var end = Start + 2 * move.Duration + dwell;
            var forecasts = 0;
            for (var k = 0; k * interval < end; k++)
            {
                predictor.Add(k * interval, Position(k * interval));
                if (k * interval < end - 0.1 || predictor.At(k * interval).Kind == PredictionKind.Held) continue;
                forecasts++;
                for (var ahead = 0.0; ahead < 0.5; ahead += 0.05)
                    Assert.That(predictor.At(k * interval + ahead).Position, Is.EqualTo(Position(k * interval + ahead)).Within(5), $"{ahead} s ahead");
            }

            Assert.That(forecasts, Is.GreaterThan(0));
        }

        [Test]
        public void At_MoveThatBrakesHarder_IsNotPredicted()
        {
            // Accelerates for 0.6 s and brakes within 0.3 s.
            double Position(double t) => t < 0 ? 0 : t < 0.6 ? 500 * t * t : t < 0.9 ? 180 + 600 * (t - 0.6) - 1000 * (t - 0.6) * (t - 0.6) : 270;
            var predictor = Alone();
            for (var t = 0.0; t < Start + 1.2; t += 0.05)
            {
                predictor.Add(t, Position(t - Start));

                Assert.That(predictor.At(t + Ahead).Kind, Is.EqualTo(PredictionKind.Held), $"{t - Start} s after the start");
            }
        }

        [Test]
        public void At_ConstantVelocity_IsNotPredicted()
        {
            var random = new Random(Seed);
            var predictor = Alone();
            for (var k = 0; k < 200; k++)
            {
                predictor.Add(k * 0.05, 20.0 * k + 0.1 * random.NextDouble());

                Assert.That(predictor.At(k * 0.05 + Ahead).Kind, Is.EqualTo(PredictionKind.Held), $"seed {Seed}, sample {k}");
            }
        }

        [Test]
        public void At_ExtremeSamples_IsFinite()
        {
            var random = new Random(Seed);
            var values = new[] { 0, 1, 1e300, -1e300, 1e49, double.Epsilon, 3, 3, 3, 2, 1, 4 };
            var predictor = Alone();
            for (var k = 0; k < 2000; k++)
            {
                predictor.Add(k * 0.05, values[random.Next(values.Length)]);

                Assert.That(double.IsFinite(predictor.At(k * 0.05 + Ahead).Position), $"seed {Seed}, sample {k}");
            }
        }

        // Moves of different strokes, none of which has been seen before.
        [Test]
        public void Adaptive_MovesThatBrakeAsTheyAccelerate_HaveSmallerErrors()
        {
            double with = Rms(PredictionParts.Joint), without = Rms(PredictionParts.Joint & ~PredictionParts.Braking);

            Assert.That(with, Is.LessThan(0.97 * without), $"seed {Seed}");
        }

        static JointPredictor Alone() => TestPredictors.Of(new BrakingForecaster(new MotionHistory(1)));

        static double Rms(PredictionParts parts)
        {
            const double interval = 0.05, slot = 2;
            var random = new Random(Seed);
            var predictor = Predictors.Adaptive(PredictionLimits.Unlimited, parts);
            var moves = Array.ConvertAll(new double[20], _ => new SevenPhaseProfile(random.Next(-400, 400), 500, 2000, 15_000));
            double squares = 0;
            var count = 0;
            for (var k = 0; (k + 3) * interval < slot * moves.Length; k++, count++)
            {
                predictor.Add(k * interval, Position(k * interval));
                squares += Math.Pow(predictor.At(k * interval + Ahead).Position - Position(k * interval + Ahead), 2);
            }

            return Math.Sqrt(squares / count);

            double Position(double t)
            {
                var position = 0.0;
                for (var i = 0; i < moves.Length; i++) position += moves[i].PositionAt(t - i * slot - Start);
                return position;
            }
        }
    }
}
