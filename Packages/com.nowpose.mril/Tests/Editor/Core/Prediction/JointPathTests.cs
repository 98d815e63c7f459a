using System;
using Nowpose.Prediction.Planning;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class JointPathTests
    {
        static readonly double[] Times = { 0.5, 1.1, 1.3, 2 };

        static double[] Each(Func<double, double> f) => Array.ConvertAll(Times, t => f(t));

        static double MaxError(JointPath path, Func<double, double> motion)
        {
            var max = 0.0;
            for (var t = Times[0]; t <= Times[Times.Length - 1]; t += 0.01)
                max = Math.Max(max, Math.Abs(path.At(t, out _) - motion(t)));
            return max;
        }

        [Test]
        public void At_PositionsOnly_InterpolatesLinearly()
        {
            var path = new JointPath(Times, Each(t => t * t));

            Assert.That(path.At(0.8, out var velocity), Is.EqualTo((0.25 + 1.21) / 2).Within(1e-12));
            Assert.That(velocity, Is.EqualTo((1.21 - 0.25) / 0.6).Within(1e-12));
        }

        [Test]
        public void At_WithVelocities_IsExactForCubics()
        {
            Func<double, double> motion = t => 1 + t - 2 * t * t + 0.7 * t * t * t;
            var velocities = Each(t => 1 - 4 * t + 2.1 * t * t);

            Assert.That(MaxError(new JointPath(Times, Each(motion), velocities), motion), Is.LessThan(1e-12));
            Assert.That(MaxError(new JointPath(Times, Each(motion)), motion), Is.GreaterThan(0.01), "straight lines are not");
        }

        [Test]
        public void At_WithAccelerations_IsExactForQuintics()
        {
            Func<double, double> motion = t => Math.Pow(t, 5) - 2 * Math.Pow(t, 4) + t * t;
            var velocities = Each(t => 5 * Math.Pow(t, 4) - 8 * Math.Pow(t, 3) + 2 * t);
            var accelerations = Each(t => 20 * Math.Pow(t, 3) - 24 * t * t + 2);

            Assert.That(MaxError(new JointPath(Times, Each(motion), velocities, accelerations), motion), Is.LessThan(1e-12));
            Assert.That(MaxError(new JointPath(Times, Each(motion), velocities), motion), Is.GreaterThan(1e-3), "cubics are not exact");
        }

        [Test]
        public void At_PathWithDerivatives_ReturnsTheSlopeAsVelocity()
        {
            var path = new JointPath(Times, Each(Math.Sin), Each(Math.Cos), Each(t => -Math.Sin(t)));

            for (var t = 0.55; t < 1.95; t += 0.1)
            {
                path.At(t, out var velocity);
                Assert.That(velocity, Is.EqualTo((path.At(t + 1e-6, out _) - path.At(t - 1e-6, out _)) / 2e-6).Within(1e-6));
            }
        }

        [Test]
        public void At_VelocityMissingAtAPoint_IsAStraightLineUpToThePoint()
        {
            var velocities = Each(t => 2 * t);
            velocities[1] = double.NaN;
            var path = new JointPath(Times, Each(t => t * t), velocities);

            Assert.That(path.At(0.8, out _), Is.EqualTo((0.25 + 1.21) / 2).Within(1e-12));
            Assert.That(path.At(1.7, out _), Is.EqualTo(1.7 * 1.7).Within(1e-12));
        }

        [Test]
        public void At_OutsideThePath_ReturnsTheEndPosition()
        {
            var path = new JointPath(Times, Each(t => t));

            Assert.That(path.At(-1, out var before), Is.EqualTo(0.5));
            Assert.That(path.At(7, out var after), Is.EqualTo(2));
            Assert.That(before, Is.EqualTo(0));
            Assert.That(after, Is.EqualTo(0));
        }

        [Test]
        public void EndsAtRest_LastVelocity_DeterminesTheResult()
        {
            Assert.That(new JointPath(Times, Each(t => t)).EndsAtRest, Is.True, "a plan without velocities ends at rest");
            Assert.That(new JointPath(Times, Each(t => t), Each(t => t - 2)).EndsAtRest, Is.True);
            Assert.That(new JointPath(Times, Each(t => t), Each(_ => 1)).EndsAtRest, Is.False);
        }

        [Test]
        public void Create_TimesNotIncreasing_IsRefused()
        {
            Assert.Throws<ArgumentException>(() => new JointPath(new double[] { 0, 1, 1 }, new double[3]));
            Assert.Throws<ArgumentException>(() => new JointPath(Array.Empty<double>(), Array.Empty<double>()));
            Assert.Throws<ArgumentException>(() => new JointPath(new double[] { 0, 1 }, new double[3]));
            Assert.Throws<ArgumentException>(() => new JointPath(new double[] { 0, 1 }, new double[2], new double[1]));
        }
    }
}
