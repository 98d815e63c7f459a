using System;
using Nowpose.Frames;
using Nowpose.Kinematics;
using Nowpose.Simulation;
using Nowpose.Tests.Core.Frames;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests released objects whose source is a noisy tracker that does not report the grip.</summary>
    public class GripNoiseTests
    {
        // Returns a tracker with noise of 1 mm and 0.1° in each component.
        static Func<double, PoseSample> Tracker(int seed, Func<double, double> x) =>
            BodyMotions.WithNoise(t => new PoseSample(t, new Vector3D(x(t), 0, 0), UnitQuaternion.Identity), seed);

        static RigidTransform PoseOf(in PoseSample sample) => sample.Rotation.At(sample.Position.X, sample.Position.Y, sample.Position.Z);

        static CellSession Released(Func<double, RigidTransform> source)
        {
            var (cell, grip) = NewCell("box");
            cell.Sampling = t =>
            {
                cell.SendJoints(t, Shoulder(t), 0);
                cell.Send("world", "box", t, source(t));
            };
            cell.Send("grip", 19, 0);
            Until(cell, Close);
            cell.Send("grip", Close, 1);
            Until(cell, Open - 0.2);
            Assert.That(grip.Held, Is.EqualTo("box"));
            cell.Send("grip", Open, 0);
            Until(cell, Open + 0.5);
            return cell;
        }

        [Category("Study")]
        [Test]
        public void GripperOpens_SourceAtRestWithNoise_ObjectStaysWhereItWasReleased([Values(1, 2, 3)] int seed)
        {
            var tracker = Tracker(seed, _ => 1);
            var cell = Released(t => PoseOf(tracker(t)));
            var released = Find(cell, "box").World;
            Assert.That(Distance(released, Tool(Shoulder(Open))), Is.LessThan(0.01));

            Until(cell, Open + 60, _ => Assert.That(Distance(Find(cell, "box").World, released), Is.LessThan(1e-9), "seed " + seed));
        }

        [Category("Study")]
        [Test]
        public void GripperOpens_NoiseInOneComponent_ObjectStaysWhereItWasReleased([Values(1, 2, 3)] int seed)
        {
            var random = new Random(seed);
            var cell = Released(_ => At(1 + 0.001 * random.NextNormal(), 0));
            var released = Find(cell, "box").World;

            Until(cell, Open + 60, _ => Assert.That(Distance(Find(cell, "box").World, released), Is.LessThan(1e-9), "seed " + seed));
        }

        // The last digit of an encoder changes now and then, first after the noise has been measured.
        [Test]
        public void GripperOpens_SourceAtRestChangesByItsResolution_ObjectStaysWhereItWasReleased()
        {
            const double resolution = 1e-4;
            var cell = Released(t => At(t > Open + 1 && Math.Round(t / CellSession.Interval) % 30 == 0 ? 1 + resolution : 1, 0));
            var released = Find(cell, "box").World;

            Until(cell, Open + 10, t => Assert.That(Distance(Find(cell, "box").World, released), Is.LessThan(1e-9), $"{t} s"));
        }

        // For example, a program that publishes a pose only when the object is moved.
        [Test]
        public void GripperOpens_SourceWithoutNoiseReportsOneOtherPose_ObjectFollowsTheSource()
        {
            var cell = Released(t => At(1, 0));
            cell.Sampling = t => cell.SendJoints(t, Shoulder(t), 0);

            cell.Send("world", "box", Open + 0.6, At(1.002, 0));
            Until(cell, Open + 1);

            Assert.That(Find(cell, "box").Reach, Is.Null);
        }

        [TestCase(1.0, 0.15)]
        [TestCase(0.1, 0.35)]
        [TestCase(0.01, 2.5)]
        public void GripperOpens_SourceMovesWithNoise_ObjectFollowsTheSource(double speed, double withinSeconds)
        {
            const double start = Open + 2;
            double X(double t) => 1 - speed * Math.Max(0, t - start);
            var tracker = Tracker(4, X);
            var cell = Released(t => PoseOf(tracker(t)));
            var released = Find(cell, "box").World;
            Until(cell, start);
            Assert.That(Distance(Find(cell, "box").World, released), Is.LessThan(1e-9));

            Until(cell, start + CellSession.Latency + withinSeconds);

            Assert.That(Find(cell, "box").Reach, Is.Null);
        }

        [Test]
        public void GripperOpens_SourceTracksTheHeldObject_ObjectFollowsTheSourceImmediately()
        {
            double X(double t) => Math.Cos(Shoulder(Math.Min(Math.Max(t, Close), Open)));
            double Y(double t) => Math.Sin(Shoulder(Math.Min(Math.Max(t, Close), Open)));

            var cell = Released(t => At(X(t), Y(t)));

            Assert.That(Find(cell, "box").Reach, Is.Null);
            Assert.That(Distance(Find(cell, "box").World, At(X(Open), Y(Open))), Is.LessThan(1e-6));
        }
    }
}
