using System;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class MessageJointsTests
    {
        readonly MessageJoints _joints = new MessageJoints(TestRobot.Model);

        static string Name(int joint) => TestRobot.Model.MovingJoints[joint].Name;

        int[] Of(params string[] names) => _joints.Of(new JointStateMessage(ControlTime.FromSeconds(1), names, new double[names.Length])).ToArray();

        [Test]
        public void Of_NamesInAnyOrder_ReturnsTheJointIndicesOfTheRobot()
        {
            Assert.That(Of(Name(1), "unknown", Name(0)), Is.EqualTo(new[] { 1, -1, 0 }));
        }

        [Test]
        public void Of_MoreSourcesThanTheCacheHolds_AreDistinguished()
        {
            var sources = new[]
            {
                new[] { Name(0) }, new[] { Name(1) }, new[] { Name(0), Name(1) }, new[] { Name(1), Name(0) }, new[] { "x" }, Array.Empty<string>(),
            };
            var expected = new[] { new[] { 0 }, new[] { 1 }, new[] { 0, 1 }, new[] { 1, 0 }, new[] { -1 }, Array.Empty<int>() };

            for (var round = 0; round < 3; round++)
                for (var i = 0; i < sources.Length; i++) Assert.That(Of(sources[i]), Is.EqualTo(expected[i]), "round " + round + ", source " + i);
        }
    }
}
