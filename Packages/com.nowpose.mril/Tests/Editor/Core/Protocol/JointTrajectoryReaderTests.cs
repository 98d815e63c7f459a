using System;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Tests.Core.Protocol.RosbridgeTexts;

namespace Nowpose.Tests.Core.Protocol
{
    /// <summary>Checks which trajectory messages the reader accepts and which it rejects.</summary>
    public class JointTrajectoryReaderTests
    {
        static string TrajectoryPoint(double seconds, string more = "") => FormattableString.Invariant(
            $"{{\"positions\":[1],\"time_from_start\":{{\"sec\":{Math.Floor(seconds)},\"nanosec\":{(seconds - Math.Floor(seconds)) * 1e9}}}{more}}}");

        static string Trajectory(params string[] points) => Publish(
            "{" + Stamp + ",\"joint_names\":[\"a\"],\"points\":[" + string.Join(",", points) + "]}", "/joint_trajectory");

        [Test]
        public void TryRead_PointWithWrongLength_IsRefused()
        {
            const string Point = "{\"positions\":[1,2],\"time_from_start\":{\"sec\":0,\"nanosec\":0}}";

            Refuse(Publish("{" + Stamp + ",\"joint_names\":[\"a\"],\"points\":[" + Point + "]}", "/joint_trajectory"), DropReason.LengthMismatch);
        }

        [Test]
        public void TryRead_TrajectoryWithoutPoints_IsRead()
        {
            Assert.That(RosbridgeReader.TryRead(Trajectory(), out var message, out _), Is.True);
            Assert.That(message.JointTrajectory.Points, Is.Empty);
        }

        [TestCase(0, 0)]
        [TestCase(1, 0.5)]
        [TestCase(-1, 0)]
        public void TryRead_TrajectoryTimesNotIncreasing_AreRefused(double first, double second)
        {
            Refuse(Trajectory(TrajectoryPoint(first), TrajectoryPoint(second)), DropReason.OutOfRange);
        }

        // In seconds, two such times are the same double, so that the path between them would have no length.
        [Test]
        public void TryRead_TrajectoryTimesTooLateToDiffer_AreRefused()
        {
            string Late(int nanoseconds) => "{\"positions\":[1],\"time_from_start\":{\"sec\":1000000000,\"nanosec\":" + nanoseconds + "}}";

            Refuse(Trajectory(Late(0), Late(100)), DropReason.OutOfRange);
        }

        [TestCase(",\"accelerations\":[1,2]")]
        [TestCase(",\"velocities\":[1,2]")]
        public void TryRead_DerivativesWithWrongLength_AreRefused(string more)
        {
            Refuse(Trajectory(TrajectoryPoint(0, more)), DropReason.LengthMismatch);
        }
    }
}
