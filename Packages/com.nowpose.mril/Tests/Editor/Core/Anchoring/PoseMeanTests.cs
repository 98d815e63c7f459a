using System;
using Nowpose.Anchoring;
using Nowpose.Anchoring.Fitting;
using Nowpose.Kinematics;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Anchoring
{
    public class PoseMeanTests
    {
        const double Degree = Math.PI / 180;

        static readonly RigidTransform True = RigidTransform.FromXyzRpy(2, -1, 0.3, 1, -0.5, 2);

        Random _random;
        PoseWindow _window;

        [SetUp]
        public void Begin()
        {
            _random = new Random(11);
            _window = new PoseWindow();
        }

        void Add(in RigidTransform pose) => _window.Add(pose, HeadsetTime.FromSeconds(_window.Count / 30.0));

        /// <param name="metres">Standard deviation along each axis, in m.</param>
        RigidTransform Noisy(double metres, double radians) => True
            * PoseNumbers.Turn(radians * Normal(), radians * Normal(), radians * Normal())
                .MovedTo(metres * Normal(), metres * Normal(), metres * Normal());

        double Normal() => _random.NextNormal();

        PoseMean Mean() => PoseMean.Of(_window, _window.Count, new PoseMeanSpace());

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(60)]
        public void Of_EqualPoses_ReturnsThePose(int count)
        {
            for (var i = 0; i < count; i++) Add(True);

            var mean = Mean();

            Assert.That(mean.Pose.DistanceTo(True), Is.LessThan(1e-12));
            Assert.That(mean.Pose.AngleTo(True), Is.LessThan(1e-9));
            Assert.That(mean.Inliers, Is.EqualTo(count));
        }

        [Test]
        public void Of_TwoPoses_ReturnsTheMidpoint()
        {
            Add(True * PoseNumbers.Turn(0, 0, 4 * Degree).MovedTo(0.01, 0, 0));
            Add(True * PoseNumbers.Turn(0, 0, -4 * Degree).MovedTo(-0.01, 0, 0));

            var mean = Mean();

            Assert.That(mean.Pose.DistanceTo(True), Is.LessThan(1e-12));
            Assert.That(mean.Pose.AngleTo(True), Is.LessThan(1e-9));
        }

        [Test]
        public void Of_NoisyPoses_EstimatesSpreadAndError()
        {
            for (var i = 0; i < 200; i++) Add(Noisy(0.002, 0.5 * Degree));

            var mean = Mean();

            Assert.That(mean.SpreadMetres, Is.EqualTo(0.002 * Math.Sqrt(3)).Within(0.0003));
            Assert.That(mean.SpreadRadians, Is.EqualTo(0.5 * Degree * Math.Sqrt(3)).Within(0.08 * Degree));
            Assert.That(mean.Inliers, Is.GreaterThan(200 - 8), "noisy poses are not outliers");
            Assert.That(mean.Pose.DistanceTo(True), Is.LessThan(3 * mean.ErrorMetres));
            Assert.That(mean.Pose.AngleTo(True), Is.LessThan(3 * mean.ErrorRadians));
            Assert.That(mean.ErrorMetres, Is.EqualTo(mean.SpreadMetres / Math.Sqrt(mean.Inliers)).Within(1e-9));
        }

        // Typical outliers in individual frames of a tracker: rotated by 90°, at the origin, or shifted by 50 mm.
        [TestCase(0.1)]
        [TestCase(0.3)]
        public void Of_TypicalOutliers_ExcludesTheOutliers(double share)
        {
            for (var i = 0; i < 100; i++)
            {
                var noisy = Noisy(0.001, 0.2 * Degree);
                if (i >= share * 100) Add(noisy);
                else if (i % 3 == 0) Add(noisy * PoseNumbers.Turn(0, 0, 90 * Degree));
                else if (i % 3 == 1) Add(RigidTransform.Identity);
                else Add(noisy.MovedTo(noisy.X + 0.05, noisy.Y, noisy.Z));
            }

            var mean = Mean();

            Assert.That(mean.Inliers, Is.EqualTo(100 - share * 100).Within(2));
            Assert.That(mean.Pose.DistanceTo(True), Is.LessThan(0.0006));
            Assert.That(mean.Pose.AngleTo(True), Is.LessThan(0.12 * Degree));
        }

        [Test]
        public void Of_PartOfTheWindow_UsesTheNewestPoses()
        {
            for (var i = 0; i < 300; i++) Add(RigidTransform.Identity);
            for (var i = 0; i < 10; i++) Add(True);

            Assert.That(PoseMean.Of(_window, 10, new PoseMeanSpace()).Pose.DistanceTo(True), Is.LessThan(1e-12));
            Assert.That(_window.Count, Is.EqualTo(PoseWindow.Capacity), "the window drops the oldest poses");
        }
    }
}
