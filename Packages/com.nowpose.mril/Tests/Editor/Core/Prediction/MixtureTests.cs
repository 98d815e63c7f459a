using System;
using System.Linq;
using Nowpose.Motion;
using Nowpose.Prediction;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Prediction
{
    public class MixtureTests
    {
        internal const PredictionParts WithoutRepetition = PredictionParts.Joint & ~PredictionParts.Repetition;

        const double Interval = 0.05;

        // Moves at 1 m/s. In some cases, the joint had another velocity before t = 0. Samples from before this change must not affect the prediction.
        [TestCase(double.NaN)]
        [TestCase(-0.5)]
        [TestCase(2)]
        public void At_ConstantVelocity_IsUnbiasedFromTheThirdSample(double velocityBefore)
        {
            foreach (var interval in new[] { 0.01, 0.02, 0.0333, 0.05, 0.1 })
            {
                var predictor = Predictors.Create("adaptive", new PredictionLimits());
                var before = double.IsNaN(velocityBefore) ? 0 : (int)(5 / interval);
                for (var k = -before; k < 60; k++)
                {
                    var time = k * interval;
                    predictor.Add(new JointSample(time, k < 0 ? velocityBefore * time : time), time - interval + 0.13);
                    for (var ahead = 0.0; k >= 2 && ahead <= 0.25; ahead += 0.01)
                        Assert.That(predictor.At(time + ahead).Position, Is.EqualTo(time + ahead).Within(1e-4), interval + " s, sample " + k + ", " + ahead + " s");
                }
            }
        }

        [Test]
        public void At_ConstantAcceleration_IsMoreAccurateThanALine()
        {
            var predictor = Fed(30, t => 0.4 * t * t);
            var t = 29 * Interval + 0.15;
            var line = Fed(TestPredictors.Polynomial(1, 1), 30, x => 0.4 * x * x);

            Assert.That(Math.Abs(predictor.At(t).Position - 0.4 * t * t), Is.LessThan(0.2 * Math.Abs(line.At(t).Position - 0.4 * t * t)));
        }

        // The joint already moves at the first sample. The forecast from this sample alone has a large error, which is equal for all forecasters and
        // must not hide their differences. The noise of the samples is uniform, 0.1 mm RMS.
        [Test]
        public void At_FirstSampleDuringAMotion_IsAccurateAfterOneSecond()
        {
            double early = 0, late = 0;
            for (var seed = 0; seed < 10; seed++)
            {
                var (predictor, random) = (Predictors.Create("adaptive", new PredictionLimits()), new Random(seed));
                for (var k = 0; k < 300; k++)
                {
                    var (time, shown) = (k * Interval, k * Interval + 0.13);
                    predictor.Add(new JointSample(time, 0.3 * time + 3.5e-4 * (random.NextDouble() - 0.5)), shown);
                    var error = Math.Pow(predictor.At(shown).Position - 0.3 * shown, 2);
                    if (time > 1 && time < 3) early += error / 2;
                    if (time > 10) late += error / 5;
                }
            }

            Assert.That(Math.Sqrt(early / late), Is.LessThan(4));
        }

        [Test]
        public void At_Standstill_IsExactlyTheSample()
        {
            Assert.That(Fed(50, _ => 1.25).At(49 * Interval + 0.2).Position, Is.EqualTo(1.25));
        }

        // An encoder that toggles between two counts before the first motion.
        [Test]
        public void At_AlternatingSamples_AreNoJumpsAndStayWithinTheirNoise()
        {
            var predictor = Mixed();
            for (var k = 0; k < 100; k++)
            {
                predictor.Add(k * Interval, 1e-3 * (k % 2));
                var shown = predictor.At(k * Interval + 0.1);
                if (k < 20) continue;

                Assert.That(shown.Kind, Is.EqualTo(PredictionKind.Predicted), "sample " + k);
                Assert.That(Math.Abs(shown.Position - 5e-4), Is.LessThan(1.6e-3), "sample " + k);
            }
        }

        // Three samples a second are connected, because the default maximum gap is 0.5 s.
        [Test]
        public void At_SlowSource_LearnsTheWeights()
        {
            var predictor = Mixed();
            double squares = 0, line = 0;
            for (var k = 0; k < 200; k++)
            {
                double Position(double t) => Math.Sin(0.8 * t);
                var time = 0.35 * k;
                predictor.Add(new JointSample(time, Position(time)), time - 0.05);
                if (k < 50) continue;
                squares += Math.Pow(predictor.At(time + 0.2).Position - Position(time + 0.2), 2);
                line += Math.Pow(Position(time) + 0.2 * (Position(time) - Position(time - 0.35)) / 0.35 - Position(time + 0.2), 2);
            }

            Assert.That(squares, Is.LessThan(0.05 * line));
        }

        [Test]
        public void At_BeforeAndAfterTheFirstSample_IsNoneThenHeld()
        {
            var predictor = Mixed();

            Assert.That(predictor.At(1).Kind, Is.EqualTo(PredictionKind.None));
            predictor.Add(1, 7);
            Assert.That(predictor.At(1.1).Kind, Is.EqualTo(PredictionKind.Held));
            Assert.That(predictor.At(1.1).Position, Is.EqualTo(7));
        }

        [Test]
        public void At_BeyondTheHorizonCap_HoldsTheValueAtTheCap()
        {
            var predictor = Fed(Mixed(new PredictionLimits(horizonCap: 0.2)), 60, t => t);
            var newest = 59 * Interval;

            Assert.That(predictor.At(newest + 0.199).Kind, Is.EqualTo(PredictionKind.Predicted));
            Assert.That(predictor.At(newest + 0.25).Kind, Is.EqualTo(PredictionKind.Held));
            Assert.That(predictor.At(newest + 5).Position, Is.EqualTo(predictor.At(newest + 0.2).Position).Within(1e-12));
        }

        [Test]
        public void At_AfterAPause_IsHeld()
        {
            var predictor = Fed(Mixed(new PredictionLimits(maximumGap: 0.5)), 60, t => t);
            var after = 59 * Interval + 2;
            predictor.Add(after, 9);

            Assert.That(predictor.At(after + 0.1).Position, Is.EqualTo(9));
            Assert.That(predictor.At(after + 0.1).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void At_PositionLimits_AreRespected()
        {
            var predictor = Fed(Mixed(new PredictionLimits(upper: 2.96)), 60, t => t);

            Assert.That(predictor.At(59 * Interval + 0.2).Position, Is.EqualTo(2.96));
        }

        [Test]
        public void Add_OvertakenSample_PredictsNearlyAsIfInOrder()
        {
            var inOrder = Mixed();
            var overtaken = Mixed();
            var lost = Mixed();
            foreach (var k in Enumerable.Range(0, 21)) inOrder.Add(Sample(k));
            foreach (var k in Enumerable.Range(0, 18).Append(19).Append(18).Append(20)) overtaken.Add(Sample(k));
            foreach (var k in Enumerable.Range(0, 21).Where(k => k != 18)) lost.Add(Sample(k));

            double At(JointPredictor predictor) => predictor.At(20 * Interval + 0.1).Position;
            Assert.That(Math.Abs(At(overtaken) - At(inOrder)), Is.LessThan(0.3 * Math.Abs(At(lost) - At(inOrder))));
        }

        [Test]
        public void Reset_AfterSamples_EqualsANewMixture()
        {
            var used = Fed(300, t => Math.Sin(5 * t));
            used.Reset();
            var fresh = Mixed();
            for (var k = 0; k < 100; k++)
            {
                used.Add(Sample(k));
                fresh.Add(Sample(k));

                Assert.That(used.At(k * Interval + 0.1).Position, Is.EqualTo(fresh.At(k * Interval + 0.1).Position).Within(1e-9));
            }
        }

        [TestCase(1e-3)]
        [TestCase(1e3)]
        public void At_OtherUnit_ScalesThePrediction(double unit)
        {
            var plain = Fed(100, Wave);
            var scaled = Fed(100, t => unit * Wave(t));
            var t0 = 99 * Interval + 0.12;

            Assert.That(scaled.At(t0).Position / unit, Is.EqualTo(plain.At(t0).Position).Within(1e-4));
        }

        [Test]
        public void At_ExtremeSamples_IsFinite()
        {
            var values = new[] { 0, 1e300, -1e300, double.Epsilon, 1e-300, double.MaxValue, -double.MaxValue, 5, 5, 5 };
            var random = new Random(3);
            var predictor = Mixed();
            var t = 0.0;
            for (var i = 0; i < 2000; i++)
            {
                t += Math.Pow(10, -7 + 8 * random.NextDouble());
                predictor.Add(t, values[random.Next(values.Length)]);

                Assert.That(double.IsFinite(predictor.At(t + random.NextDouble()).Position), "seed 3, sample " + i);
            }
            for (var k = 1; k < 400; k++) predictor.Add(t + k * Interval, Wave(k * Interval));
            Assert.That(predictor.At(t + 399 * Interval + 0.05).Position, Is.EqualTo(Wave(399 * Interval + 0.05)).Within(0.05), "it recovers");
        }

        // Some of the newest samples are from before an emergency stop. A polynomial through them overshoots; the mixture must not.
        [Test]
        public void At_EmergencyStop_IsFarMoreAccurateThanAQuadratic()
        {
            double Stopped(double t) => Math.Min(t, 2.512);
            var stacked = Fed(Mixed(), 53, Stopped);
            var quadratic = Fed(TestPredictors.Polynomial(2, 2), 53, Stopped);
            var t0 = 52 * Interval + 0.1;

            Assert.That(Math.Abs(stacked.At(t0).Position - 2.512), Is.LessThan(0.25 * Math.Abs(quadratic.At(t0).Position - 2.512)));
        }

        // The displayed joint must not vibrate at rest. A quadratic through samples 50 ms apart amplifies noise about 14 times when it
        // extrapolates by 120 ms.
        [TestCase(0.05, 0.0001)]
        [TestCase(0.02, 0.0005)]
        public void At_NoisyRestAfterMotion_DoesNotAmplifyTheNoise(double interval, double noise)
        {
            var random = new Random(5);
            var predictor = Mixed();
            double squares = 0, count = 0;
            for (var t = 0.0; t < 40; t += interval)
            {
                var truth = t < 15 ? Math.Sin(2 * t) : Math.Sin(30);
                predictor.Add(t, truth + noise * (random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5) * 2);
                if (t < 17) continue;
                squares += Math.Pow(predictor.At(t + 0.12).Position - truth, 2);
                count++;
            }

            Assert.That(Math.Sqrt(squares / count), Is.LessThan(8 * noise), "seed 5");
        }

        [Test]
        public void At_VelocityAndAccelerationProvided_AreUsed()
        {
            var move = new SevenPhaseProfile(1, 2, 10, 100);
            double Place(double t) => Math.Floor(t / 2) + move.PositionAt(t % 2);
            var withDerivatives = Mixed();
            var positionsOnly = Mixed();
            double derivativeSquares = 0, positionSquares = 0;
            for (var k = 0; k < 400; k++)
            {
                var t = k * 0.047;
                withDerivatives.Add(new JointSample(t, Place(t), t, move.VelocityAt(t % 2), move.AccelerationAt(t % 2)));
                positionsOnly.Add(t, Place(t));
                if (k < 100) continue;
                derivativeSquares += Math.Pow(withDerivatives.At(t + 0.12).Position - Place(t + 0.12), 2);
                positionSquares += Math.Pow(positionsOnly.At(t + 0.12).Position - Place(t + 0.12), 2);
            }

            Assert.That(derivativeSquares, Is.LessThan(0.6 * positionSquares));
        }

        [Test]
        public void At_ProvidedVelocityIsAlwaysZero_IsIgnoredAfterThreeSeconds()
        {
            var predictor = Mixed();
            double squares = 0, held = 0;
            for (var k = 0; k < 200; k++)
            {
                var t = k * Interval;
                predictor.Add(new JointSample(t, Wave(t), t, 0));
                if (k < 60) continue;
                squares += Math.Pow(predictor.At(t + 0.1).Position - Wave(t + 0.1), 2);
                held += Math.Pow(Wave(t) - Wave(t + 0.1), 2);
            }

            Assert.That(squares, Is.LessThan(0.1 * held));
        }

        static double Wave(double t) => Math.Sin(4 * t) + 0.3 * Math.Sin(9.7 * t);

        static JointSample Sample(int k) => new JointSample(k * Interval, Wave(k * Interval));

        static JointPredictor Mixed(PredictionLimits limits = null) => Predictors.Adaptive(limits ?? PredictionLimits.Unlimited, WithoutRepetition);

        static JointPredictor Fed(int samples, Func<double, double> motion) => Fed(Mixed(), samples, motion);

        // Three frames at 60 Hz are displayed before each sample is added; the first of them shows the time 100 ms after the previous sample.
        static JointPredictor Fed(JointPredictor predictor, int samples, Func<double, double> motion)
        {
            for (var k = 0; k < samples; k++) predictor.Add(new JointSample(k * Interval, motion(k * Interval)), (k - 1) * Interval + 0.1 + 2 / 60.0);
            return predictor;
        }
    }
}
