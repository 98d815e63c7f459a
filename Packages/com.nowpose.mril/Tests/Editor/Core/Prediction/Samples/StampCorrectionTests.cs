using System;
using Nowpose.Prediction;
using Nowpose.Prediction.Samples;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction.Samples
{
    public class StampCorrectionTests
    {
        const int Seed = 21;

        readonly StampCorrection _stamps = new StampCorrection(components: 1);
        Random _random;

        [SetUp]
        public void Restart()
        {
            _stamps.Reset();
            _random = new Random(Seed);
        }

        [TestCase(0.050, 0.005, 0)]
        [TestCase(0.050, 0.010, 0)]
        [TestCase(0.020, 0.005, 0)]
        [TestCase(0.100, 0.010, 0.01)]
        [TestCase(0.050, 0.010, 0.02)]
        [TestCase(0.0333, 0.004, 0.02)]
        public void Correct_PeriodicSourceWithScatteredStamps_RemovesMostOfTheScatter(double interval, double scatter, double loss)
        {
            // The standard deviation of uniform scatter is its half-width divided by √3.
            Assert.That(RmsErrorOfTheLast200(interval, scatter, 0, loss), Is.LessThan(0.32 * scatter / Math.Sqrt(3)), "seed " + Seed);
        }

        [Test]
        public void Correct_JitteredSamplingWithTrueStamps_KeepsTheStamps()
        {
            Assert.That(RmsErrorOfTheLast200(0.050, 0, 0.008, 0), Is.EqualTo(0), "seed " + Seed);
        }

        [Test]
        public void Correct_ExactStamps_AreUnchanged()
        {
            Assert.That(RmsErrorOfTheLast200(0.050, 0, 0, 0.05), Is.EqualTo(0));
        }

        [Test]
        public void Correct_StampsWithoutAPeriod_AreUnchanged()
        {
            var touched = 0;
            for (double t = 0, i = 0; i < 500; i++)
            {
                t += 0.01 - 0.05 * Math.Log(1 - _random.NextDouble());
                if (Correct(t, t) != t) touched++;
            }

            // A few random stamps in a row can look regular by chance.
            Assert.That(touched, Is.LessThan(25), "seed " + Seed);
        }

        [Test]
        public void Correct_OvertakenSample_GetsItsPeriodicTime()
        {
            for (var k = 0; k < 100; k++)
                if (k != 97) Correct(Scattered(k * 0.05, 0.005), k * 0.05);

            var corrected = _stamps.Correct(new JointSample(Scattered(97 * 0.05, 0.005), Motion(97 * 0.05)), isNewest: false);

            Assert.That(corrected, Is.EqualTo(97 * 0.05).Within(0.0015), "seed " + Seed);
        }

        [Test]
        public void Correct_PeriodAfterAPause_IsEstimatedAgain()
        {
            for (var k = 0; k < 100; k++) Correct(Scattered(k * 0.05, 0.005), k * 0.05);

            Assert.That(WorstError(100, 30, k => 60.0173 + k * 0.02, t => Scattered(t, 0.004)), Is.LessThan(0.002), "seed " + Seed);
        }

        [TestCase(0.05, 0.02)]
        [TestCase(0.1, 0.05)]
        public void Correct_SourceBecomesFaster_IsFollowedImmediately(double before, double after)
        {
            double TimeOf(int k) => Math.Min(k + 1, 200) * before + Math.Max(k - 199, 0) * after;

            Assert.That(WorstError(400, 199, TimeOf, t => t + 0.001 * _random.NextDouble()), Is.LessThan(0.01), "seed " + Seed);
        }

        [Test]
        public void Correct_OccasionallyLateStamps_GetTheirPeriodicTime()
        {
            Assert.That(WorstError(400, 100, k => k * 0.05, t => t + (_random.NextDouble() < 0.05 ? 0.02 : 0)), Is.LessThan(0.004), "seed " + Seed);
        }

        [Test]
        public void Reset_AfterStamps_ClearsThePeriod()
        {
            for (var k = 0; k < 100; k++) Correct(Scattered(k * 0.05, 0.005), k * 0.05);

            _stamps.Reset();

            Assert.That(Correct(1.2345, 1), Is.EqualTo(1.2345));
        }

        static double Motion(double t) => 0.5 * Math.Sin(3 * t) + 0.2 * Math.Sin(7.1 * t);

        double Scattered(double time, double scatter) => time + scatter * (2 * _random.NextDouble() - 1);

        double Correct(double stamp, double time) => _stamps.Correct(new JointSample(stamp, Motion(time)), isNewest: true);

        // Returns the maximum error of the corrected stamps, s, without the first samples.
        double WorstError(int samples, int first, Func<int, double> timeOf, Func<double, double> stampAt)
        {
            var worst = 0.0;
            for (var k = 0; k < samples; k++)
            {
                var error = Math.Abs(Correct(stampAt(timeOf(k)), timeOf(k)) - timeOf(k));
                if (k > first) worst = Math.Max(worst, error);
            }
            return worst;
        }

        double RmsErrorOfTheLast200(double interval, double stampError, double trueJitter, double loss)
        {
            const int samples = 500;
            var squares = 0.0;
            for (var k = 0; k < samples; k++)
            {
                var time = Scattered(3 + k * interval, trueJitter);
                var stamp = Scattered(time, stampError);
                if (_random.NextDouble() < loss) continue;
                var error = Correct(stamp, time) - time;
                if (k >= samples - 200) squares += error * error;
            }
            return Math.Sqrt(squares / 200);
        }
    }
}
