using System;
using Nowpose.Anchoring;
using Nowpose.Frames;
using Nowpose.Prediction;
using Nowpose.Prediction.Mixing;
using NUnit.Framework;
using Nowpose.Kinematics;
using Nowpose.Simulation;

namespace Nowpose.Tests.Core.Frames
{
    public class BodyMixtureTests
    {
        const double Interval = 0.05, Latency = 0.1;

        static BodyPredictor Fed(Func<int, Vector3D> motion, int samples, UnitQuaternion? rotation = null)
        {
            var body = new BodyPredictor("adaptive", PredictionLimits.Unlimited);
            for (var k = 0; k < samples; k++) Add(body, k, motion(k), rotation ?? UnitQuaternion.Identity);
            return body;
        }

        static void Add(BodyPredictor body, int k, in Vector3D position, in UnitQuaternion rotation) =>
            body.Add(new PoseSample(k * Interval, position, rotation), k * Interval + Latency);

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(20)]
        public void At_ConstantVector_ReturnsItAtAnyTime(int samples)
        {
            var body = Fed(_ => new Vector3D(0.7, -3, 0.1), samples);

            foreach (var time in new[] { -1, 0, 0.01, 0.5, 3, 1e6 }) Assert.That(body.PositionAt(time), Is.EqualTo(new Vector3D(0.7, -3, 0.1)));
        }

        [Test]
        public void At_OnlyThePositionMoves_KeepsTheRotationExactly()
        {
            var rotation = UnitQuaternion.Exp(new Vector3D(0.3, -0.2, 1));
            var body = Fed(k => new Vector3D(Math.Sin(0.1 * k), 0, 0), 200, rotation);

            Assert.That(body.At(199 * Interval + Latency).AngleTo(rotation.At(0, 0, 0)), Is.Zero);
        }

        /// <summary>
        /// The displacement between two samples of a slow motion is within the rounding tolerance, but the sum of the displacements is not.
        /// </summary>
        [Test]
        public void At_SlowMotion_IsPredicted()
        {
            var body = Fed(k => new Vector3D(4e-11 * k, 0, 0), 101);

            Assert.That(body.PositionAt(102 * Interval).X, Is.EqualTo(4e-11 * 102).Within(1e-14));
        }

        /// <summary>
        /// The weights from the noise would hold the object at the newest sample. In the first case, the object moves at 0.4 m/s; in the second one, it stays
        /// after an impulse of one sample.
        /// </summary>
        [TestCase(0.02, 0.04, 0.07, 0.1)]
        [TestCase(0.02, 0.02, 0.015, 0.025)]
        public void At_SecondSampleOutOfTheNoise_ContinuesOnlyAMotion(double first, double second, double min, double max)
        {
            var random = new Random(31);
            var body = Fed(_ => new Vector3D(random.NextNormal(), random.NextNormal(), random.NextNormal()) * 1e-4, 200);

            Add(body, 200, new Vector3D(first, 0, 0), UnitQuaternion.Identity);
            Add(body, 201, new Vector3D(second, 0, 0), UnitQuaternion.Identity);

            Assert.That(body.PositionAt(201 * Interval + Latency).X, Is.InRange(min, max));
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(20)]
        public void At_FirstChangeAfterARest_ContinuesAtTheNewSpeed(int rest)
        {
            var body = Fed(_ => new Vector3D(0.7, 0, 0), rest);

            Add(body, rest, new Vector3D(0.73, 0.03, 0), UnitQuaternion.Identity);

            Assert.That((body.PositionAt((rest + 2) * Interval) - new Vector3D(0.79, 0.09, 0)).Length, Is.LessThan(1e-12));
        }

        // After an abrupt stop, the samples before it say nothing about the motion. With the whole history, a parabola would overshoot by 24 mm.
        [Test]
        public void At_AbruptStop_DoesNotUseTheSamplesBeforeIt()
        {
            var body = Fed(k => new Vector3D(0.02 * Math.Min(k, 100), 0, 0), 102);
            for (var k = 102; k < 104; k++)
            {
                Assert.That(body.PositionAt((k - 1) * Interval + Latency).X, Is.EqualTo(2).Within(0.011), k + " samples");
                Add(body, k, new Vector3D(2, 0, 0), UnitQuaternion.Identity);
            }

            Assert.That(body.PositionAt(103 * Interval + Latency).X, Is.EqualTo(2).Within(1e-3));
        }

        // The mean of the samples is nearer to the true position than the newest one.
        [Test]
        public void At_NoiseAtRest_ErrorIsSmallerThanThatOfTheNewestSample()
        {
            var (squares, held, center) = (0.0, 0.0, new Vector3D(0.5e-3, 0.5e-3, 0.5e-3));
            for (var seed = 0; seed < 20; seed++)
            {
                var random = new Random(seed);
                var body = new BodyPredictor("adaptive", PredictionLimits.Unlimited);
                for (var k = 0; k < 18; k++)
                {
                    Add(body, k, new Vector3D(random.NextDouble(), random.NextDouble(), random.NextDouble()) * 1e-3, UnitQuaternion.Identity);
                    if (k < 4) continue;
                    squares += Math.Pow((body.PositionAt(k * Interval + Latency) - center).Length, 2);
                    held += Math.Pow((new Vector3D(body.Hold.X, body.Hold.Y, body.Hold.Z) - center).Length, 2);
                }
            }

            Assert.That(Math.Sqrt(squares / held), Is.LessThan(0.7));
        }

        // Until the first horizon has passed, no error is known. At 10 ms, forecasts for 100 ms amplify noise to many times its size.
        [Test]
        public void At_RandomWalkInTheFirstHorizon_StaysNearTheNewestSample()
        {
            const double interval = 0.01;
            var (squares, held) = (0.0, 0.0);
            for (var seed = 0; seed < 20; seed++)
            {
                var (random, position) = (new Random(seed), new Vector3D(0, 0, 0));
                var body = new BodyPredictor("adaptive", PredictionLimits.Unlimited);
                for (var k = 0; k < 10; k++)
                {
                    position += new Vector3D(random.NextNormal(), random.NextNormal(), random.NextNormal()) * 1e-3;
                    body.Add(new PoseSample(k * interval, position, UnitQuaternion.Identity), k * interval + Latency);
                    if (k < 4) continue;
                    squares += Math.Pow((body.PositionAt(k * interval + Latency) - position).Length, 2);
                    held += 3 * 1e-6 * Latency / interval;
                }
            }

            Assert.That(Math.Sqrt(squares / held), Is.LessThan(2), "distance from the newest sample, relative to the error of hold");
        }

        // One component moves smoothly, the others only have noise: their weights are not those of the motion.
        [Test]
        public void At_OtherComponentsHaveOnlyNoise_AmplifiesItLess()
        {
            var (random, squares, noise) = (new Random(12), 0.0, 5e-3);
            var body = new BodyPredictor("adaptive", PredictionLimits.Unlimited);
            for (var k = 0; k < 800; k++)
            {
                var t = k * Interval;
                Add(body, k, new Vector3D(0.3 * Math.Sin(4 * t), noise * random.NextNormal(), noise * random.NextNormal()), UnitQuaternion.Identity);
                if (k < 200) continue;
                var shown = body.PositionAt(t + Latency);
                squares += (shown.Y * shown.Y + shown.Z * shown.Z) / (2 * 600);
            }

            Assert.That(Math.Sqrt(squares), Is.LessThan(1.7 * noise));
        }

        // Objects of one cell use the same forecasters in turn. The second object is sampled at other times.
        [Test]
        public void At_SharedForecasters_EqualsOwnForecasters()
        {
            var shared = Predictors.ForecastersOfObjects();
            var objects = new BodyPredictor[4];
            for (var i = 0; i < objects.Length; i++) objects[i] = new BodyPredictor("adaptive", new PredictionLimits(), forecasters: i < 2 ? shared : null);
            for (var k = 0; k < 300; k++)
                for (var i = 0; i < objects.Length; i++)
                {
                    var sample = BodyMotions.HandHeld(k * (i % 2 == 0 ? Interval : 0.03));
                    objects[i].Add(sample, sample.Time + Latency);
                }

            for (var i = 0; i < 2; i++)
            {
                var time = objects[i].NewestTime + Latency;
                Assert.That(objects[i].At(time).DistanceTo(objects[i + 2].At(time)), Is.LessThan(1e-7));
            }
        }
    }
}
