using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Forecasting;
using Nowpose.Prediction.Samples;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Forecasting
{
    public class RestDetectorTests
    {
        const int Seed = 5;

        readonly SampleHistory<JointSample> _history = new SampleHistory<JointSample>(24);
        readonly RestDetector _rest = new RestDetector();
        Random _random;

        [SetUp]
        public void Restart()
        {
            _history.Clear();
            _rest.Reset();
            _random = new Random(Seed);
        }

        [TestCase(0.01, 0)]
        [TestCase(0.05, 0)]
        [TestCase(0.1, 0)]
        [TestCase(0.05, 1e-4)]
        public void Add_ConstantSpeedForMinutes_IsNeverAtRest(double interval, double noise)
        {
            var (rests, _) = Feed(0, 120, interval, t => t + Noise(noise));

            Assert.That(rests, Is.EqualTo(0), "seed " + Seed);
        }

        [Test]
        public void Add_SlowMotionAfterFastMotion_IsNotRestAfterAMinute()
        {
            double Position(double t) => t < 10 ? Math.Sin(2 * t) : Math.Sin(20) + 0.1 * (t - 10);
            Feed(0, 70, 0.05, Position);

            var (rests, _) = Feed(70, 120, 0.05, Position);

            Assert.That(rests, Is.EqualTo(0));
        }

        [Test]
        public void Add_ContinuousMotion_IsNeverClassifiedAsNoise()
        {
            var (_, noises) = Feed(0, 120, 0.05, t => Math.Sin(2 * t));

            Assert.That(noises, Is.EqualTo(0));
        }

        [TestCase(0.02, 0)]
        [TestCase(0.02, 1e-3)]
        [TestCase(0.05, 1e-4)]
        [TestCase(0.1, 1e-3)]
        public void Add_RestAfterMotion_IsAtRest(double interval, double noise)
        {
            double Position(double t) => Math.Sin(2 * Math.Min(t % 20, 10)) + Noise(noise);
            Feed(0, 31, interval, Position);

            var (rests, noises) = Feed(31, 40, interval, Position);

            Assert.That(rests, Is.GreaterThan(0.95), "seed " + Seed);
            Assert.That(noises, noise > 0 ? Is.GreaterThan(0.7) : Is.EqualTo(0), "seed " + Seed);
        }

        [TestCase(2)]
        [TestCase(10)]
        [TestCase(60)]
        public void Add_GapInSamplesDuringANoisyRest_IsAtRestAgainWithinFiveSeconds(double pause)
        {
            for (var seed = 1; seed <= 50; seed++)
            {
                Restart();
                _random = new Random(seed);
                double Position(double t) => Math.Sin(2 * Math.Min(t, 10)) + Noise(1e-3);
                Feed(0, 20, 0.05, Position);

                Feed(20 + pause, 25 + pause, 0.05, Position);

                Assert.That(_rest.IsAtRest, "seed " + seed);
            }
        }

        double Noise(double halfWidth) => halfWidth * (2 * _random.NextDouble() - 1);

        // Returns the fraction of the samples that are classified as rest and the fraction that are classified as only noise.
        (double Rests, double Noises) Feed(double from, double to, double interval, Func<double, double> positionAt)
        {
            int rests = 0, noises = 0, count = 0;
            for (var t = from; t < to; t += interval, count++)
            {
                var before = _history.Count > 0 ? t - _history.NewestTime : 0;
                _history.Add(new JointSample(t, positionAt(t)));
                _rest.Add(_history, before);
                if (_rest.IsAtRest) rests++;
                if (_rest.IsOnlyNoise) noises++;
            }
            return (rests / (double)count, noises / (double)count);
        }
    }
}
