using System;
using NUnit.Framework;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.State;

namespace Nowpose.Tests.Core.Prediction
{
    /// <summary>Contains the example forecaster of prediction.md and a test that the adaptive predictor learns to use it.</summary>
    public class PredictionManualExamples
    {
        // Forecasts a line whose speed decays, for drives that have just been switched off.
        sealed class CoastingForecaster : Forecaster
        {
            const double TimeConstant = 0.2;

            MotionState _motion;

            public override int UsedSamples => 2;

            public override bool Solve(MotionState motion)
            {
                _motion = motion;
                return !motion.IsStill;
            }

            public override double At(double ahead, int component) =>
                _motion.Velocity[component] * TimeConstant * (1 - Math.Exp(-ahead / TimeConstant));
        }

        [Test]
        public void Adaptive_WithAnotherForecaster_LearnsToUseIt()
        {
            var predictor = Predictors.Adaptive(PredictionLimits.Unlimited, PredictionParts.Joint & ~PredictionParts.Repetition, new CoastingForecaster());
            var usual = Predictors.Adaptive(PredictionLimits.Unlimited, PredictionParts.Joint & ~PredictionParts.Repetition);

            Assert.That(Coasting(predictor), Is.LessThan(0.8 * Coasting(usual)));
        }

        // Returns the sum of the squared errors 0.2 s ahead for an axis that is pushed every second and then coasts. Forecasts made shortly
        // before or after a push are excluded.
        static double Coasting(JointPredictor predictor)
        {
            const double interval = 0.1, ahead = 0.2;
            var sum = 0.0;
            for (var i = 0; i < 1200; i++)
            {
                var time = i * interval;
                predictor.Add(new JointSample(time, Position(time)), time + ahead - interval);
                var error = predictor.At(time + ahead).Position - Position(time + ahead);
                if (i > 600 && i % 10 > 2 && i % 10 < 8) sum += error * error;
            }
            return sum;
        }

        static double Position(double time) => Math.Floor(time + 1e-9) + 1 - Math.Exp(-(time - Math.Floor(time + 1e-9)) / 0.2);
    }
}
