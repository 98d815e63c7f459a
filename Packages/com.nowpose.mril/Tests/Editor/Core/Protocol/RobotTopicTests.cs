using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol
{
    public class RobotTopicTests
    {
        [TestCase("/joint_states", "", "/joint_states")]
        [TestCase("/arm1/joint_states", "arm1", "/joint_states")]
        [TestCase("/A_2/joint_trajectory", "A_2", "/joint_trajectory")]
        [TestCase("/x/robot_description", "x", "/robot_description")]
        [TestCase("/arm1/tf", "", "/arm1/tf")]
        [TestCase("/nowpose/joint_status", "", "/nowpose/joint_status")]
        [TestCase("/my_joint_states", "", "/my_joint_states")]
        [TestCase("joint_states", "", "joint_states")]
        public void Parse_Topic_ReturnsNamespaceAndTopicOfTheRobot(string name, string robot, string kind)
        {
            var topic = RobotTopic.Parse(name);

            Assert.That(topic.IsValid, Is.True);
            Assert.That(topic.Robot, Is.EqualTo(robot));
            Assert.That(topic.Kind, Is.EqualTo(kind));
        }

        [TestCase("/1arm/joint_states")]
        [TestCase("/_arm/joint_states")]
        [TestCase("/arm-1/joint_states")]
        [TestCase("/a/b/joint_states")]
        [TestCase("//joint_states")]
        [TestCase("/ärm/joint_states")]
        [TestCase("/arm 1/robot_description")]
        [TestCase("/arm1//joint_states")]
        public void Parse_InvalidNamespace_IsNotValid(string name) => Assert.That(RobotTopic.Parse(name).IsValid, Is.False);

        [TestCase(0, true)]
        [TestCase(1, false)]
        public void HasNameLength_AroundTheLimit_DoesNotCountTheNamespace(int more, bool expected)
        {
            var name = new string('n', ProtocolLimits.NameLength + more);

            Assert.That(RobotTopic.HasNameLength(name), Is.EqualTo(expected));
            Assert.That(RobotTopic.HasNameLength("arm1/" + name), Is.EqualTo(expected));
            Assert.That(RobotTopic.HasNameLength("/" + name), Is.False);
        }

        [TestCase(32, true)]
        [TestCase(33, false)]
        public void Parse_Namespace_IsValidUpTo32Characters(int length, bool expected) =>
            Assert.That(RobotTopic.Parse("/" + new string('r', length) + "/joint_states").IsValid, Is.EqualTo(expected));

        [TestCase("")]
        [TestCase("arm1")]
        public void NameOf_ParsedAgain_ReturnsTheNamespace(string robot)
        {
            var topic = RobotTopic.Parse(RobotTopic.NameOf(robot, RosTopics.JointStates));

            Assert.That(topic.Robot, Is.EqualTo(robot));
            Assert.That(topic.Kind, Is.EqualTo(RosTopics.JointStates));
        }

        [Test]
        public void TryRead_JointStateInNamespace_IsReadWithItsRobot()
        {
            const string Text = "{\"op\":\"publish\",\"topic\":\"/arm1/joint_states\",\"msg\":{\"header\":{\"stamp\":{\"sec\":12,\"nanosec\":0}},"
                + "\"name\":[\"a\"],\"position\":[1.5]}}";

            Assert.That(RosbridgeReader.TryRead(Text, out var message, out var reason), Is.True, reason.ToString());
            Assert.That(message.RobotTopic.Robot, Is.EqualTo("arm1"));
            Assert.That(message.JointState.Positions, Is.EqualTo(new[] { 1.5 }));
        }

        [Test]
        public void TryRead_LongDescriptionInNamespace_IsRead()
        {
            var text = RosbridgeWriter.Publish("/arm1/robot_description", new StringMessage(new string('u', 1_000_000)));

            Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, reason.ToString());
            Assert.That(message.Data.Length, Is.EqualTo(1_000_000));
        }

        [Test]
        public void TryRead_MoreTopicsThanTheCacheHolds_AreAllRead()
        {
            var reader = new RosbridgeReader();
            for (var round = 0; round < 2; round++)
            {
                for (var i = 0; i < 200; i++)
                {
                    var text = System.Text.Encoding.UTF8.GetBytes(RosbridgeWriter.Subscribe("/r" + i + "/joint_states"));
                    Assert.That(reader.TryRead(text, out var message, out _), Is.True);
                    Assert.That(message.RobotTopic.Robot, Is.EqualTo("r" + i));
                }
            }
        }
    }
}
