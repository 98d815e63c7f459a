using System;
using Nowpose.Frames;
using Nowpose.Prediction;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Frames
{
    public class RepeatedBodyTests
    {
        const double Interval = 0.05, Latency = 0.1;

        // Corners of a path, m. The object moves from corner to corner in 0.6 s and dwells there for 0.25 s.
        static readonly Vector3D[] Corners =
        {
            new Vector3D(0, 0, 0), new Vector3D(0.4, 0, 0), new Vector3D(0.4, 0.3, 0), new Vector3D(0.1, 0.3, 0.2), new Vector3D(0, 0.1, 0.2)
        };

        const double Leg = 0.85, Moving = 0.6;

        [TestCase(0)]
        [TestCase(0.0002)]
        public void At_CycleWithSeveralCorners_HasASmallerErrorFromTheSecondCycleOn(double noise)
        {
            var (first, later) = Errors(leg => Corners[leg % Corners.Length], noise);

            Assert.That(later, Is.LessThan(0.5 * first));
        }

        // Only the heights repeat: a pallet with many places.
        [Test]
        public void At_PlacesThatNeverRepeat_HaveTheErrorOfTheFirstCycle()
        {
            var random = new Random(4);
            var places = new Vector3D[200];
            for (var i = 0; i < places.Length; i++) places[i] = new Vector3D(random.NextDouble(), random.NextDouble(), 0.2 * (i % 2));

            var (first, later) = Errors(leg => places[leg], 0);

            Assert.That(later, Is.LessThan(1.1 * first));
        }

        [Test]
        public void Reset_AfterSeveralCycles_DiscardsThem()
        {
            var (fed, empty) = (new BodyPredictor("adaptive", PredictionLimits.Unlimited), new BodyPredictor("adaptive", PredictionLimits.Unlimited));
            var cycle = Corners.Length * Leg;
            for (var k = 0; k * Interval < 6 * cycle; k++) Add(fed, k, leg => Corners[leg % Corners.Length], 0);
            fed.Reset();
            for (var k = 0; k * Interval < cycle; k++)
            {
                Add(fed, k, leg => Corners[leg % Corners.Length], 0);
                Add(empty, k, leg => Corners[leg % Corners.Length], 0);

                Assert.That(fed.At(k * Interval + Latency), Is.EqualTo(empty.At(k * Interval + Latency)));
            }
        }

        // Returns the RMS errors in the first cycle and from the fourth to the sixth.
        static (double First, double Later) Errors(Func<int, Vector3D> corner, double noise)
        {
            var predictor = new BodyPredictor("adaptive", PredictionLimits.Unlimited);
            var cycle = Corners.Length * Leg;
            double first = 0, later = 0;
            for (var k = 0; k * Interval < 6 * cycle; k++)
            {
                Add(predictor, k, corner, noise);
                var time = k * Interval + Latency;
                var error = (predictor.PositionAt(time) - At(time, corner)).Length;
                if (time < cycle) first += error * error;
                else if (time > 3 * cycle) later += error * error / 3;
            }
            return (Math.Sqrt(first), Math.Sqrt(later));
        }

        static void Add(BodyPredictor predictor, int k, Func<int, Vector3D> corner, double noise)
        {
            var random = new Random(k);
            double Noise() => noise * (random.NextDouble() + random.NextDouble() - 1);
            var position = At(k * Interval, corner) + new Vector3D(Noise(), Noise(), Noise());
            predictor.Add(new PoseSample(k * Interval, position, UnitQuaternion.Identity), k * Interval + Latency);
        }

        static Vector3D At(double time, Func<int, Vector3D> corner)
        {
            var leg = (int)(time / Leg);
            var u = Math.Min(1, (time - leg * Leg) / Moving);
            return corner(leg) + (corner(leg + 1) - corner(leg)) * (u * u * u * (10 + u * (6 * u - 15)));
        }
    }
}
