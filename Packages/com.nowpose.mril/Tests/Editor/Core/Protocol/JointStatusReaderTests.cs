using System.Linq;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol
{
    public class JointStatusReaderTests
    {
        static string Message(params (string Joint, string Value)[] values) =>
            "{\"op\":\"publish\",\"topic\":\"/nowpose/joint_status\",\"msg\":{\"header\":{\"stamp\":{\"sec\":12,\"nanosec\":0}},"
            + "\"status\":[{\"level\":2,\"name\":\"joints\",\"message\":\"\",\"hardware_id\":\"gateway\",\"values\":["
            + string.Join(",", values.Select(each => "{\"key\":\"" + each.Joint + "\",\"value\":\"" + each.Value + "\"}")) + "]}]}}";

        static DropReason ReasonOf(string text) =>
            RosbridgeReader.TryRead(text, out _, out var reason) ? DropReason.None : reason;

        static JointReport[] Read(string text)
        {
            Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), reason.ToString());
            return message.JointStatus.Joints.ToArray();
        }

        [TestCase("live 5000.125", JointDataState.Live, "")]
        [TestCase("rest 5000.125 silent, and read back as before", JointDataState.Rest, "silent, and read back as before")]
        [TestCase("stale 5000.125", JointDataState.Stale, "")]
        [TestCase("refused 5000.125 Bad status", JointDataState.Refused, "Bad status")]
        [TestCase("fault 5000.125 node deleted", JointDataState.Fault, "node deleted")]
        [TestCase("missing 5000.125 ", JointDataState.Missing, "")]
        public void TryRead_JointStatus_ReturnsStateStartTimeAndReason(string value, JointDataState state, string reason)
        {
            var joint = Read(Message(("a3", value))).Single();

            Assert.That(joint.Joint, Is.EqualTo("a3"));
            Assert.That(joint.State, Is.EqualTo(state));
            Assert.That(joint.Since, Is.EqualTo(ControlTime.FromSeconds(5000.125)));
            Assert.That(joint.Reason, Is.EqualTo(reason));
        }

        [Test]
        public void TryRead_NegativeStartTime_IsRead() =>
            Assert.That(Read(Message(("a3", "fault -2.500 node deleted"))).Single().Since, Is.EqualTo(ControlTime.FromSeconds(-2.5)));

        [Test]
        public void TryRead_AllJointsLive_ReturnsNoJoints() => Assert.That(Read(Message()), Is.Empty);

        [TestCase("gone 5000.125")]
        [TestCase("Fault 5000.125")]
        [TestCase("0 5000.125")]
        [TestCase("fault")]
        [TestCase("fault ")]
        [TestCase("")]
        [TestCase("fault yesterday")]
        [TestCase("fault --1")]
        [TestCase("fault NaN")]
        [TestCase("fault 1e9")]
        [TestCase("fault 99999999999")]
        public void TryRead_InvalidValue_IsDropped(string value) =>
            Assert.That(ReasonOf(Message(("a1", "rest 1.000"), ("a3", value))), Is.EqualTo(DropReason.OutOfRange));

        [Test]
        public void TryRead_DuplicateJoint_IsDropped() =>
            Assert.That(ReasonOf(Message(("a3", "rest 1"), ("a3", "fault 1"))), Is.EqualTo(DropReason.DuplicateName));

        [Test]
        public void TryRead_MoreJointsThanAllowed_IsDropped()
        {
            (string, string)[] Joints(int count) => Enumerable.Range(0, count).Select(i => ("j" + i, "fault 1")).ToArray();

            Assert.That(ReasonOf(Message(Joints(ProtocolLimits.Joints))), Is.EqualTo(DropReason.None));
            Assert.That(ReasonOf(Message(Joints(ProtocolLimits.Joints + 1))), Is.EqualTo(DropReason.TooManyJoints));
        }

        [Test]
        public void TryRead_JointNameTooLong_IsDropped() =>
            Assert.That(ReasonOf(Message((new string('a', ProtocolLimits.NameLength + 1), "fault 1"))), Is.EqualTo(DropReason.NameTooLong));

        [TestCase(32, 128, DropReason.None)]
        [TestCase(32, 129, DropReason.NameTooLong)]
        public void TryRead_JointInANamespace_HasTheNameLengthWithoutTheNamespace(int robot, int joint, DropReason expected) =>
            Assert.That(ReasonOf(Message((new string('r', robot) + "/" + new string('a', joint), "fault 1"))), Is.EqualTo(expected));

        [Test]
        public void TryRead_LongReason_IsShortenedToOneLine()
        {
            var reason = Read(Message(("a3", "fault 1 deleted\\nby " + new string('x', 1000)))).Single().Reason;

            Assert.That(reason.Length, Is.InRange(200, 256));
            Assert.That(reason, Does.StartWith("deleted by xxx").And.Contain("x … x"));
        }
    }
}
