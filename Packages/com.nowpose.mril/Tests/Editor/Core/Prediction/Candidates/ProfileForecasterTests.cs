using System;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Prediction.Candidates;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class ProfileForecasterTests
    {
        const double Interval = 0.05;
        const double Start = 0.5123;

        static readonly PredictionLimits Limits = new PredictionLimits(
            horizonCap: 10, maximumGap: 10, velocity: 1000, acceleration: 5000, jerk: 50_000);

        // Includes strokes too short to reach the velocity or the acceleration limit.
        [TestCase(500)]
        [TestCase(-500)]
        [TestCase(150)]
        [TestCase(-40)]
        public void At_BrakingMove_IsPredictedToItsEnd(double stroke)
        {
            var move = new SevenPhaseProfile(stroke, 1000, 5000, 50_000);
            var predictor = TestPredictors.Of(new ProfileForecaster(Limits), Limits);
            var t = 0.0;
            for (; t < Start + move.Duration - 0.03; t += Interval) predictor.Add(t, 7 + move.PositionAt(t - Start));

            for (var ahead = 0.0; ahead < 0.5; ahead += 0.01)
                Assert.That(predictor.At(predictor.NewestTime + ahead).Position,
                    Is.EqualTo(7 + move.PositionAt(predictor.NewestTime + ahead - Start)).Within(0.05));
        }

        [Test]
        public void At_StartOfAMove_AccelerationPhaseIsPredicted()
        {
            var move = new SevenPhaseProfile(500, 1000, 5000, 50_000);
            var predictor = TestPredictors.Of(new ProfileForecaster(Limits), Limits);
            for (var t = 0.0; t < Start + 0.1; t += Interval) predictor.Add(t, move.PositionAt(t - Start));

            // Two samples determine the whole acceleration phase, but not the deceleration phase.
            var last = Start + 0.25;
            Assert.That(predictor.At(last).Position, Is.EqualTo(move.PositionAt(last - Start)).Within(0.05));
        }

        [Test]
        public void At_OtherMotion_IsRarelyPredicted()
        {
            var predictor = TestPredictors.Of(new ProfileForecaster(Limits), Limits);
            var said = 0;
            for (var k = 0; k < 200; k++)
            {
                predictor.Add(k * Interval, 100 * Math.Sin(3 * k * Interval));
                if (k > 5 && predictor.At(k * Interval + 0.1).Kind != PredictionKind.Held) said++;
            }

            Assert.That(said, Is.LessThan(10));
        }

        [Test]
        public void At_Rest_StaysAtRest()
        {
            var predictor = TestPredictors.Of(new ProfileForecaster(Limits), Limits);
            for (var k = 0; k < 10; k++) predictor.Add(k * Interval, 3);

            Assert.That(predictor.At(9 * Interval + 0.2).Position, Is.EqualTo(3));
        }

        [Test]
        public void HasLimits_LimitMissing_ReturnsFalse()
        {
            Assert.That(ProfileForecaster.HasLimits(new PredictionLimits(velocity: 1, acceleration: 1)), Is.False);
            Assert.That(ProfileForecaster.HasLimits(Limits));
        }
    }
}
