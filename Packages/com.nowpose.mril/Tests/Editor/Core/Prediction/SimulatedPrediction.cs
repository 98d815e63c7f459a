using System;
using System.Collections.Generic;
using Nowpose.Motion;
using Nowpose.Prediction;

namespace Nowpose.Tests.Core.Prediction
{
    /// <summary>
    /// Simulates section 2.2 of the paper in virtual time: an axis moves back and forth by 500 mm with a 7-phase profile (1000 mm/s, 5000
    /// mm/s², 50 000 mm/s³, 0.4 s dwell). It is displayed at 60 frames per second; each sample arrives with a constant latency.
    /// </summary>
    sealed class SimulatedPrediction
    {
        const double FrameRateHz = 60;
        const double Dwell = 0.4;
        const double WarmUp = 1.2;
        const double Length = 13.2;

        static readonly SevenPhaseProfile Move = new SevenPhaseProfile(500, 1000, 5000, 50000);

        public double SamplingInterval { get; set; } = 0.05;
        public double Latency { get; set; } = 0.1;
        public double StampError { get; set; }

        /// <summary>Returns the RMS error divided by the RMS error of hold, as the mean of runs with random phases of sampling and frames.</summary>
        public double Ratio(string predictor, int seed)
        {
            const int phases = 16;
            var sum = 0.0;
            for (var phase = 0; phase < phases; phase++) sum += OneRun(predictor, new Random(seed * phases + phase));
            return sum / phases;
        }

        public static double Position(double t)
        {
            var half = Move.Duration + Dwell;
            var inCycle = t % (2 * half);
            return inCycle < half ? Move.PositionAt(inCycle) : 500 - Move.PositionAt(inCycle - half);
        }

        double OneRun(string name, Random random)
        {
            var joint = new DisplayedJoint(Predictors.Create(name, PredictionLimits.Unlimited));
            var sampleTime = random.NextDouble() * SamplingInterval;
            var framePhase = random.NextDouble() / FrameRateHz;
            double held = 0, predicted = 0;
            for (var frame = 0; frame < Length * FrameRateHz; frame++)
            {
                var t = framePhase + frame / FrameRateHz;
                for (; sampleTime + Latency <= t; sampleTime += SamplingInterval)
                {
                    var stamp = sampleTime + StampError * (2 * random.NextDouble() - 1);
                    joint.Add(new JointSample(stamp, Position(sampleTime), sampleTime));
                }
                var shown = joint.Show(t).Position;
                if (t < WarmUp) continue;
                held += Squared(joint.Predictor.Hold - Position(t));
                predicted += Squared(shown - Position(t));
            }
            return Math.Sqrt(predicted / held);
        }

        static double Squared(double x) => x * x;
    }
}
