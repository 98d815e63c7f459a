using System;
using NUnit.Framework;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Prediction.Candidates;
using Nowpose.Simulation;
using Nowpose.Tests.Core.Frames;

namespace Nowpose.Tests.Core.Prediction.Candidates
{
    public class ScatterDetectorTests
    {
        readonly PositionWindow _window = new PositionWindow(ScatterDetector.Window, components: 3);

        [SetUp]
        public void ClearWindow() => _window.Clear();

        void Add(ScatterDetector detector, in Vector3D position)
        {
            _window.Add(new[] { position.X, position.Y, position.Z });
            detector.Add(_window.Positions, _window.Count);
        }

        bool Scatters(Func<double, PoseSample> motion, int samples, double interval)
        {
            _window.Clear();
            var detector = new ScatterDetector(components: 3);
            for (var k = 0; k < samples; k++) Add(detector, motion(k * interval).Position);
            return detector.Scatters;
        }

        [TestCase(3, false)]
        [TestCase(5, true)]
        [TestCase(40, true)]
        public void Scatters_NoiseAtRest_IsTrueWithEnoughSamples(int samples, bool expected) =>
            Assert.That(Scatters(BodyMotions.WithNoise(BodyMotions.Rest, seed: 11), samples, 0.02), Is.EqualTo(expected));

        [TestCase(0.02)]
        [TestCase(0.1)]
        public void Scatters_SmoothMotion_IsFalse(double interval)
        {
            for (var samples = 4; samples < 60; samples++)
                Assert.That(Scatters(BodyMotions.HandHeld, samples, interval), Is.False, samples + " samples");
        }

        /// <summary>In the first case, the step is as short as the noise. In the second one, it is longer than the noise and no longer than the window.</summary>
        [TestCase(0.5, true)]
        [TestCase(2.5, false)]
        [TestCase(40, false)]
        public void Scatters_StepOutOfTheNoise_IsTrueOnlyIfItIsShort(double position, bool expected)
        {
            var detector = new ScatterDetector(components: 3);
            foreach (var x in new[] { 0, 0.3, -0.2, 0.1, -0.3, 0.2, -0.1, 0.3, -0.3, 0.1, -0.2, 0.2 }) Add(detector, new Vector3D(x, 0, 0));

            Add(detector, new Vector3D(position, 0, 0));

            Assert.That(detector.Scatters, Is.EqualTo(expected));
        }

        [Test]
        public void Noise_AtRest_IsTheMeanDistanceOfConsecutiveSamples()
        {
            var rest = BodyMotions.WithNoise(BodyMotions.Rest, seed: 13);
            var detector = new ScatterDetector(components: 3);
            for (var k = 0; k < 100; k++) Add(detector, rest(0.05 * k).Position);

            // √2 · 1 mm in each of three components: the mean length of the difference is 2.26 mm.
            Assert.That(detector.Noise, Is.EqualTo(2.26e-3).Within(0.6e-3));
        }

        [Test]
        public void Mean_NoiseAtRest_IsNearTheTruePosition()
        {
            var rest = BodyMotions.WithNoise(BodyMotions.Rest, seed: 15);
            var detector = new ScatterDetector(components: 3);
            var newest = rest(0).Position;
            for (var k = 0; k < 100; k++) Add(detector, newest = rest(0.05 * k).Position);

            var mean = newest + new Vector3D(detector.Mean[0], detector.Mean[1], detector.Mean[2]);

            // The mean of 12 samples, each with a standard deviation of 1 mm in three components: 0.5 mm RMS.
            Assert.That((mean - BodyMotions.Rest(0).Position).Length, Is.LessThan(1e-3));
        }

        [Test]
        public void Noise_AfterAJumpToAPlaceWithLessNoise_IsTheNoiseThere()
        {
            var detector = new ScatterDetector(components: 3);
            var random = new Random(14);
            void AddNoise(double deviation, int samples)
            {
                _window.Clear();
                for (var k = 0; k < samples; k++)
                    Add(detector, new Vector3D(deviation * random.NextNormal(), deviation * random.NextNormal(), deviation * random.NextNormal()));
            }

            AddNoise(5e-3, 60);
            AddNoise(2e-4, 12);

            Assert.That(detector.Noise, Is.EqualTo(4.5e-4).Within(2e-4));
        }

        [Test]
        public void Scatters_EqualSamples_IsFalse() => Assert.That(Scatters(BodyMotions.Rest, 20, 0.05), Is.False);
    }
}
