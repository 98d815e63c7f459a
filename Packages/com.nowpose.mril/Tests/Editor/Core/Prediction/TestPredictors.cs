using System;
using System.Collections.Generic;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;
using Nowpose.Prediction.State;

namespace Nowpose.Tests.Core.Prediction
{
    /// <summary>Creates predictors for tests and feeds them.</summary>
    static class TestPredictors
    {
        static readonly string[] Degrees = { "hold", "linear", "quadratic", "cubic" };

        /// <summary>Creates the paper's polynomial predictor of a degree. It uses <paramref name="history"/> samples besides the newest.</summary>
        /// <param name="limits">Limits of the joint; null if it has none.</param>
        public static JointPredictor Polynomial(int degree, int history, PredictionLimits limits = null) =>
            Predictors.Create(Degrees[degree] + "-h" + history, limits ?? PredictionLimits.Unlimited);

        /// <summary>
        /// Creates a predictor with one forecaster and the given parts of the pipeline. It holds the newest sample if the forecaster cannot forecast.
        /// </summary>
        /// <param name="limits">Limits of the joint; null if it has none.</param>
        public static JointPredictor Of(Forecaster forecaster, PredictionLimits limits = null, PredictionParts parts = PredictionParts.None) =>
            Predictors.Of(forecaster, 24, limits ?? PredictionLimits.Unlimited, parts);

        /// <summary>Returns the state of a motion after its samples, which are in the order of their times.</summary>
        public static MotionState Motion(double[] times, double[] positions)
        {
            var buffer = new SampleBuffer<JointSample>(times.Length, PredictionLimits.Unlimited);
            var motion = new MotionState(1, 0, times.Length, buffer.Timing, new JointPositionCheck());
            for (var i = 0; i < times.Length; i++)
            {
                buffer.Add(new JointSample(times[i], positions[i]), displayed: double.NaN);
                motion.Take(buffer);
            }
            return motion;
        }

        public static DropReason Add(this JointPredictor predictor, double time, double position) =>
            predictor.Add(new JointSample(time, position));

        public static JointPredictor Fed(this JointPredictor predictor, IEnumerable<double> times, Func<double, double> motion)
        {
            foreach (var time in times) predictor.Add(time, motion(time));
            return predictor;
        }
    }
}
