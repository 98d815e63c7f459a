using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>
    /// Compares the default predictor with the hold, linear and quadratic predictors on simulated motions of 20 s, with and without a
    /// tracker's noise.
    /// </summary>
    [Category("Study")]
    public class BodyAccuracyTests
    {
        static readonly Dictionary<string, Func<double, PoseSample>> Motions = new Dictionary<string, Func<double, PoseSample>>
        {
            { "hand-held", BodyMotions.HandHeld },
            { "hand-held, noise", BodyMotions.WithNoise(BodyMotions.HandHeld, seed: 71) },
            { "turntable", BodyMotions.Turntable },
            { "turntable, noise", BodyMotions.WithNoise(BodyMotions.Turntable, seed: 72) },
            { "conveyor, noise", BodyMotions.WithNoise(BodyMotions.Conveyor, seed: 75) },
            { "unequal moves", BodyMotions.UnequalMoves },
            { "vehicle", BodyMotions.Vehicle },
            { "first turns", BodyMotions.FirstTurns },
            { "switched on", BodyMotions.SwitchedOn },
            { "switched turntable", BodyMotions.Switched },
            { "abrupt vehicle", BodyMotions.AbruptVehicle },
            { "reappearing workpiece", BodyMotions.Reappearing },
            { "noisy heading", BodyMotions.NoisyHeading },
            { "rest, noise", BodyMotions.WithNoise(BodyMotions.Rest, seed: 73) },
            { "jumping rate", BodyMotions.JumpingRate },
            { "constant turning, noise", BodyMotions.WithNoise(BodyMotions.Constant(new Vector3D(0.3, 0.5, 2)), seed: 74) },
        }.ToDictionary(named => named.Key, named => Remembered(named.Value));

        // All predictors, and all tests of a motion, need the same samples. Computing some of them takes longer than predicting them.
        static Func<double, PoseSample> Remembered(Func<double, PoseSample> motion)
        {
            var samples = new Dictionary<double, PoseSample>();
            return time => samples.TryGetValue(time, out var sample) ? sample : samples[time] = motion(time);
        }

        [TestCase("hand-held", 20, 100, 0.7)]
        [TestCase("hand-held", 50, 100, 0.7)]
        [TestCase("hand-held", 100, 150, 0.7)]
        [TestCase("hand-held, noise", 20, 100, 0.9)]
        [TestCase("hand-held, noise", 50, 100, 0.95)]
        [TestCase("hand-held, noise", 100, 150, 0.9)]
        [TestCase("turntable", 50, 100, 0.95)]
        [TestCase("turntable, noise", 20, 100, 0.95)]
        [TestCase("turntable, noise", 50, 100, 0.95)]
        [TestCase("conveyor, noise", 20, 100, 1.05)]
        [TestCase("conveyor, noise", 50, 100, 1.05)]
        [TestCase("conveyor, noise", 100, 150, 1.05)]
        [TestCase("unequal moves", 20, 100, 1.05)]
        [TestCase("unequal moves", 50, 100, 1.05)]
        [TestCase("unequal moves", 100, 150, 1.05)]
        [TestCase("vehicle", 20, 100, 1.05)]
        [TestCase("vehicle", 50, 100, 1.05)]
        [TestCase("vehicle", 100, 150, 1.05)]
        [TestCase("first turns", 50, 100, 1.05)]
        [TestCase("first turns", 50, 150, 1.05)]
        [TestCase("switched on", 20, 100, 1.001)]
        [TestCase("switched on", 50, 150, 1.001)]
        [TestCase("switched turntable", 20, 100, 1.05)]
        [TestCase("switched turntable", 50, 100, 1.05)]
        [TestCase("switched turntable", 100, 150, 1.05)]
        [TestCase("abrupt vehicle", 20, 100, 1.05)]
        [TestCase("abrupt vehicle", 50, 100, 1.05)]
        [TestCase("abrupt vehicle", 50, 150, 1.05)]
        [TestCase("abrupt vehicle", 100, 150, 1.05)]
        [TestCase("reappearing workpiece", 20, 100, 1.05)]
        [TestCase("reappearing workpiece", 50, 100, 1.05)]
        [TestCase("reappearing workpiece", 100, 150, 1.05)]
        [TestCase("noisy heading", 20, 100, 1.05)]
        [TestCase("noisy heading", 50, 100, 1.05)]
        [TestCase("noisy heading", 100, 150, 1.05)]
        [TestCase("jumping rate", 20, 100, 1.05)]
        [TestCase("jumping rate", 50, 100, 1.05)]
        [TestCase("jumping rate", 100, 150, 1.05)]
        [TestCase("rest, noise", 20, 100, 1.05)]
        [TestCase("rest, noise", 50, 100, 1.05)]
        [TestCase("rest, noise", 100, 150, 1.05)]
        [TestCase("constant turning, noise", 20, 100, 0.7)]
        [TestCase("constant turning, noise", 100, 150, 0.95)]
        public void Adaptive_SimulatedMotion_ErrorRelativeToTheBestFixedPredictorIsBelowTheLimit(
            string motion, int samplingMs, int latencyMs, double maxRatio)
        {
            var best = (Position: double.PositiveInfinity, Rotation: double.PositiveInfinity);
            foreach (var name in new[] { "hold", "linear", "quadratic" })
            {
                var error = Error(name, Motions[motion], samplingMs / 1000.0, latencyMs / 1000.0);
                best = (Math.Min(best.Position, error.Position), Math.Min(best.Rotation, error.Rotation));
            }

            var adaptive = Error("adaptive", Motions[motion], samplingMs / 1000.0, latencyMs / 1000.0);

            Assert.That(adaptive.Position / best.Position, Is.LessThan(maxRatio), "position");
            Assert.That(adaptive.Rotation / best.Rotation, Is.LessThan(maxRatio), "rotation");
        }

        // Without repetitions, an earlier motion does not predict when the present one ends.
        [Test]
        public void Adaptive_ConveyorSwitchedAtRandomTimes_IsNotWorseThanALine([Range(1, 8)] int seed)
        {
            var motion = BodyMotions.SwitchedConveyor(seed);

            Assert.That(Error("adaptive", motion, 0.05, 0.15).Position, Is.LessThan(1.05 * Error("linear", motion, 0.05, 0.15).Position));
        }

        // Returns the RMS errors in m and rad, at 60 frames per second.
        static (double Position, double Rotation) Error(string name, Func<double, PoseSample> motion, double sampling, double latency)
        {
            var predictor = new BodyPredictor(name, PredictionLimits.Unlimited);
            var (next, displayed, position, rotation, frames) = (0, double.NaN, 0.0, 0.0, 0);
            for (var frame = 0; frame < 1200; frame++)
            {
                var time = frame / 60.0;
                for (; next * sampling + latency <= time; next++) predictor.Add(motion(next * sampling), displayed);
                if (next < 5) continue;
                displayed = time;
                var sample = motion(time);
                var truth = sample.Rotation.At(sample.Position.X, sample.Position.Y, sample.Position.Z);
                var pose = predictor.At(time);
                position += Math.Pow(pose.DistanceTo(truth), 2);
                rotation += Math.Pow(pose.AngleTo(truth), 2);
                frames++;
            }
            return (Math.Sqrt(position / frames), Math.Sqrt(rotation / frames));
        }
    }
}
