using System;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Frames
{
    public class BodyPolynomialTests
    {
        static Vector3D Motion(double t) => new Vector3D(Math.Sin(3 * t), 1e3 + 0.2 * t * t * t, -5);

        // Returns stamps at uneven intervals.
        static double StampOf(int k) => 100 + 0.05 * k + 0.004 * Math.Sin(7 * k);

        static void Add(BodyPredictor body, double time, double order) => body.Add(new PoseSample(time, Motion(time), UnitQuaternion.Identity, order));

        /// <summary>Compares the result with the joint predictors, which fit the same polynomial to each component.</summary>
        [Test]
        public void At_UnevenlySpacedSamples_EqualsThePolynomialOfEachComponent(
            [Values("hold", "linear", "quadratic", "cubic", "quadratic-h4", "linear-h4", "linear-h9")] string name,
            [Values(1, 2, 3, 4, 12)] int samples, [Values(0.02, 0.25)] double ahead)
        {
            var body = new BodyPredictor(name, PredictionLimits.Unlimited);
            var joints = new JointPredictor[3];
            for (var i = 0; i < 3; i++) joints[i] = Predictors.Create(name, PredictionLimits.Unlimited);
            for (var k = 0; k < samples; k++)
            {
                Add(body, StampOf(k), StampOf(k));
                for (var i = 0; i < 3; i++) joints[i].Add(new JointSample(StampOf(k), Motion(StampOf(k))[i]));
            }

            var time = StampOf(samples - 1) + ahead;

            for (var i = 0; i < 3; i++) Assert.That(body.PositionAt(time)[i], Is.EqualTo(joints[i].At(time).Position).Within(1e-9), "component " + i);
        }

        [Test]
        public void At_AfterAGap_HoldsTheNewestSample()
        {
            var body = new BodyPredictor("quadratic-h4", new PredictionLimits(maximumGap: 0.5));
            foreach (var t in new[] { 1, 1.1, 1.2, 1.3, 1.81 }) Add(body, t, t);

            Assert.That((body.PositionAt(2.01) - Motion(1.81)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void At_EqualStamps_IsFinite()
        {
            var body = new BodyPredictor("quadratic", PredictionLimits.Unlimited);
            for (var order = 1; order < 5; order++) Add(body, 1, order);

            Assert.That(body.PositionAt(1.2).Length, Is.Not.NaN.And.LessThan(2e3));
        }
    }
}
