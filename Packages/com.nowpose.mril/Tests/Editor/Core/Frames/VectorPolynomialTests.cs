using System;
using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Frames
{
    public class VectorPolynomialTests
    {
        static Vector3D Motion(double t) => new Vector3D(Math.Sin(3 * t), 1e3 + 0.2 * t * t * t, -5);

        // Returns stamps at uneven intervals.
        static double StampOf(int k) => 100 + 0.05 * k + 0.004 * Math.Sin(7 * k);

        /// <summary>Compares the result with the joint predictors, which fit the same polynomial to each component.</summary>
        [Test]
        public void At_UnevenlySpacedSamples_EqualsThePolynomialOfEachComponent(
            [Values("hold", "linear", "quadratic", "quadratic-h4", "linear-h4", "linear-h9")] string name,
            [Values(1, 2, 3, 4, 12)] int samples, [Values(0.02, 0.25)] double ahead)
        {
            var degree = name.StartsWith("quadratic") ? 2 : name == "hold" ? 0 : 1;
            var mark = name.IndexOf("-h", StringComparison.Ordinal);
            var polynomial = new VectorPolynomial(degree, mark < 0 ? degree : int.Parse(name.Substring(mark + 2)));
            var joints = new JointPredictor[3];
            for (var i = 0; i < 3; i++) joints[i] = Predictors.Create(name, PredictionLimits.Unlimited);
            var recent = new RecentVectors(10, double.PositiveInfinity);
            for (var k = 0; k < samples; k++)
            {
                recent.Add(StampOf(k), Motion(StampOf(k)));
                for (var i = 0; i < 3; i++) joints[i].Add(new JointSample(StampOf(k), Motion(StampOf(k))[i]));
            }

            polynomial.Solve(recent);

            for (var i = 0; i < 3; i++)
                Assert.That(polynomial.At(ahead)[i], Is.EqualTo(joints[i].At(StampOf(samples - 1) + ahead).Position).Within(1e-9), "component " + i);
        }

        [Test]
        public void Solve_AfterAGap_HoldsTheNewestSample()
        {
            var polynomial = new VectorPolynomial(2, 4);
            var recent = new RecentVectors(10, 0.5);
            foreach (var t in new[] { 1, 1.1, 1.2, 1.3, 1.81 }) recent.Add(t, Motion(t));

            polynomial.Solve(recent);

            Assert.That((polynomial.At(0.2) - Motion(1.81)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void Solve_EqualTimes_IsFinite()
        {
            var polynomial = new VectorPolynomial(2, 2);
            var recent = new RecentVectors(10, 0.5);
            foreach (var t in new[] { 1.0, 1, 1 }) recent.Add(t, Motion(recent.Count));

            polynomial.Solve(recent);

            Assert.That(polynomial.At(0.2).Length, Is.Not.NaN.And.LessThan(2e3));
        }
    }
}
