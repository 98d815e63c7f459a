using System;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    /// <summary>Predictors of a body that have received the samples of a motion, and the comparison of poses.</summary>
    static class FedBody
    {
        public const double Interval = 0.05;

        public static BodyPredictor Fed(string name, Func<double, PoseSample> motion, int samples, double blend = 0)
        {
            var predictor = new BodyPredictor(name, PredictionLimits.Unlimited, blend);
            for (var k = 0; k < samples; k++) predictor.Add(motion(k * Interval), k * Interval + 0.1);
            return predictor;
        }

        public static RigidTransform PoseOf(in PoseSample sample) => sample.Rotation.At(sample.Position.X, sample.Position.Y, sample.Position.Z);

        public static void AssertPose(in RigidTransform actual, in RigidTransform expected, double tolerance)
        {
            Assert.That(actual.DistanceTo(expected), Is.LessThanOrEqualTo(tolerance), "m");
            Assert.That(actual.AngleTo(expected), Is.LessThanOrEqualTo(tolerance), "rad");
        }
    }
}
