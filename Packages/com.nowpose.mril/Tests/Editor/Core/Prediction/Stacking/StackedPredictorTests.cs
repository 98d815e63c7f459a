using System;
using System.Linq;
using Nowpose.Motion;
using Nowpose.Prediction;
using Nowpose.Prediction.Stacking;
using NUnit.Framework;

namespace Nowpose.Tests
{
    public class StackedPredictorTests
    {
        const double Interval = 0.05;

        [Test]
        public void At_UniformMotion_IsExact()
        {
            var predictor = Fed(200, t => 3 - 0.7 * t);

            for (var ahead = 0.0; ahead <= 0.3; ahead += 0.01)
                Assert.That(predictor.At(199 * Interval + ahead).Position, Is.EqualTo(3 - 0.7 * (199 * Interval + ahead)).Within(2e-4));
        }

        [Test]
        public void At_EndlessAcceleration_ComesNearerThanALine()
        {
            var predictor = Fed(30, t => 0.4 * t * t);
            var t = 29 * Interval + 0.15;
            var line = Fed(new PolynomialPredictor(1, 1, PredictionLimits.Unlimited), 30, x => 0.4 * x * x);

            Assert.That(Math.Abs(predictor.At(t).Position - 0.4 * t * t), Is.LessThan(0.2 * Math.Abs(line.At(t).Position - 0.4 * t * t)));
        }

        [Test]
        public void At_Standstill_StaysExactly()
        {
            Assert.That(Fed(50, _ => 1.25).At(49 * Interval + 0.2).Position, Is.EqualTo(1.25));
        }

        [Test]
        public void At_BeforeAndAfterTheFirstSample_SaysSo()
        {
            var predictor = new StackedPredictor(PredictionLimits.Unlimited);

            Assert.That(predictor.At(1).Kind, Is.EqualTo(PredictionKind.None));
            predictor.Add(new JointSample(1, 7));
            Assert.That(predictor.At(1.1).Kind, Is.EqualTo(PredictionKind.Held));
            Assert.That(predictor.At(1.1).Position, Is.EqualTo(7));
        }

        [Test]
        public void At_BeyondTheHorizonCap_HoldsTheValueThere()
        {
            var predictor = Fed(new StackedPredictor(new PredictionLimits(horizonCap: 0.2)), 60, t => t);
            var newest = 59 * Interval;

            Assert.That(predictor.At(newest + 0.199).Kind, Is.EqualTo(PredictionKind.Predicted));
            Assert.That(predictor.At(newest + 0.25).Kind, Is.EqualTo(PredictionKind.Held));
            Assert.That(predictor.At(newest + 5).Position, Is.EqualTo(predictor.At(newest + 0.2).Position).Within(1e-12));
        }

        [Test]
        public void At_AfterAPause_NothingIsPredictedAcrossIt()
        {
            var predictor = Fed(new StackedPredictor(new PredictionLimits(maximumGap: 0.5)), 60, t => t);
            var after = 59 * Interval + 2;
            predictor.Add(new JointSample(after, 9));

            Assert.That(predictor.At(after + 0.1).Position, Is.EqualTo(9));
            Assert.That(predictor.At(after + 0.1).Kind, Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void At_PositionLimits_AreKept()
        {
            var predictor = Fed(new StackedPredictor(new PredictionLimits(upper: 2.96)), 60, t => t);

            Assert.That(predictor.At(59 * Interval + 0.2).Position, Is.EqualTo(2.96));
        }

        [Test]
        public void Add_OvertakenSample_TableIsAsIfItHadComeInOrder()
        {
            var inOrder = new StackedPredictor(PredictionLimits.Unlimited);
            var overtaken = new StackedPredictor(PredictionLimits.Unlimited);
            for (var k = 0; k < 20; k++) inOrder.Add(Sample(k));
            for (var k = 0; k < 20; k++)
                if (k != 18) overtaken.Add(Sample(k));

            var before = overtaken.At(19 * Interval + 0.1).Position;
            Assert.That(overtaken.Add(Sample(18)), Is.EqualTo(SampleOutcome.Late));

            var expected = inOrder.At(19 * Interval + 0.1).Position;
            Assert.That(Math.Abs(overtaken.At(19 * Interval + 0.1).Position - expected), Is.LessThan(0.3 * Math.Abs(before - expected)));
        }

        [Test]
        public void Reset_IsLikeANewOne()
        {
            var used = Fed(300, t => Math.Sin(5 * t));
            used.Reset();
            var fresh = new StackedPredictor(PredictionLimits.Unlimited);
            for (var k = 0; k < 100; k++)
            {
                used.Add(Sample(k));
                fresh.Add(Sample(k));

                Assert.That(used.At(k * Interval + 0.1).Position, Is.EqualTo(fresh.At(k * Interval + 0.1).Position).Within(1e-9));
            }
        }

        [TestCase(1e-3)]
        [TestCase(1e3)]
        public void At_OtherUnit_IsTheSameMotion(double unit)
        {
            var plain = Fed(100, Wave);
            var scaled = Fed(100, t => unit * Wave(t));
            var t0 = 99 * Interval + 0.12;

            Assert.That(scaled.At(t0).Position / unit, Is.EqualTo(plain.At(t0).Position).Within(1e-4));
        }

        [Test]
        public void At_AbsurdSamples_IsStillFinite()
        {
            var values = new[] { 0, 1e300, -1e300, double.Epsilon, 1e-300, double.MaxValue, -double.MaxValue, 5, 5, 5 };
            var random = new Random(3);
            var predictor = new StackedPredictor(PredictionLimits.Unlimited);
            var t = 0.0;
            for (var i = 0; i < 2000; i++)
            {
                t += Math.Pow(10, -7 + 8 * random.NextDouble());
                predictor.Add(new JointSample(t, values[random.Next(values.Length)]));

                Assert.That(double.IsFinite(predictor.At(t + random.NextDouble()).Position), "seed 3, sample " + i);
            }
            for (var k = 1; k < 400; k++) predictor.Add(new JointSample(t + k * Interval, Wave(k * Interval)));
            Assert.That(predictor.At(t + 399 * Interval + 0.05).Position, Is.EqualTo(Wave(399 * Interval + 0.05)).Within(0.05), "it recovers");
        }

        // The window straddles an emergency stop: a polynomial through it swings out, the shock cuts it.
        [Test]
        public void At_RightAfterAnEmergencyStop_ErrsFarLessThanAQuadratic()
        {
            double Stopped(double t) => Math.Min(t, 2.512);
            var stacked = Fed(new StackedPredictor(PredictionLimits.Unlimited), 53, Stopped);
            var quadratic = Fed(new PolynomialPredictor(2, 2, PredictionLimits.Unlimited), 53, Stopped);
            var t0 = 52 * Interval + 0.1;

            Assert.That(Math.Abs(stacked.At(t0).Position - 2.512), Is.LessThan(0.25 * Math.Abs(quadratic.At(t0).Position - 2.512)));
        }

        // What is displayed at rest must not tremble: extrapolated noise is what a quadratic makes fifteen times of.
        [TestCase(0.05, 0.0001)]
        [TestCase(0.02, 0.0005)]
        public void At_NoisyRestAfterMotion_IsNearlyAsQuietAsTheSamples(double interval, double noise)
        {
            var random = new Random(5);
            var predictor = new StackedPredictor(PredictionLimits.Unlimited);
            double squares = 0, count = 0;
            for (var t = 0.0; t < 40; t += interval)
            {
                var truth = t < 15 ? Math.Sin(2 * t) : Math.Sin(30);
                predictor.Add(new JointSample(t, truth + noise * (random.NextDouble() + random.NextDouble() + random.NextDouble() - 1.5) * 2));
                if (t < 17) continue;
                squares += Math.Pow(predictor.At(t + 0.12).Position - truth, 2);
                count++;
            }

            Assert.That(Math.Sqrt(squares / count), Is.LessThan(8 * noise), "seed 5");
        }

        [Test]
        public void At_VelocityAndAccelerationAreTold_AreUsed()
        {
            var move = new SevenPhaseProfile(1, 2, 10, 100);
            double Place(double t) => Math.Floor(t / 2) + move.PositionAt(t % 2);
            var told = new StackedPredictor(PredictionLimits.Unlimited);
            var untold = new StackedPredictor(PredictionLimits.Unlimited);
            double toldSquares = 0, untoldSquares = 0;
            for (var k = 0; k < 400; k++)
            {
                var t = k * 0.047;
                told.Add(new JointSample(t, Place(t), t, move.VelocityAt(t % 2), move.AccelerationAt(t % 2)));
                untold.Add(new JointSample(t, Place(t)));
                if (k < 100) continue;
                toldSquares += Math.Pow(told.At(t + 0.12).Position - Place(t + 0.12), 2);
                untoldSquares += Math.Pow(untold.At(t + 0.12).Position - Place(t + 0.12), 2);
            }

            Assert.That(toldSquares, Is.LessThan(0.6 * untoldSquares));
        }

        [Test]
        public void At_VelocityToldIsAlwaysZero_IsNotBelievedForLong()
        {
            var lied = new StackedPredictor(PredictionLimits.Unlimited);
            double squares = 0, held = 0;
            for (var k = 0; k < 200; k++)
            {
                var t = k * Interval;
                lied.Add(new JointSample(t, Wave(t), t, 0));
                if (k < 60) continue;
                squares += Math.Pow(lied.At(t + 0.1).Position - Wave(t + 0.1), 2);
                held += Math.Pow(Wave(t) - Wave(t + 0.1), 2);
            }

            Assert.That(squares, Is.LessThan(0.1 * held));
        }

        static double Wave(double t) => Math.Sin(4 * t) + 0.3 * Math.Sin(9.7 * t);

        static JointSample Sample(int k) => new JointSample(k * Interval, Wave(k * Interval));

        static IJointPredictor Fed(int samples, Func<double, double> motion) =>
            Fed(new StackedPredictor(PredictionLimits.Unlimited), samples, motion);

        // Asked at 100 ms ahead all the time, so that this is the horizon it learns for.
        static IJointPredictor Fed(IJointPredictor predictor, int samples, Func<double, double> motion)
        {
            for (var k = 0; k < samples; k++)
            {
                predictor.Add(new JointSample(k * Interval, motion(k * Interval)));
                for (var frame = 0; frame < 3; frame++) predictor.At(k * Interval + 0.1 + frame / 60.0);
            }
            return predictor;
        }
    }
}
