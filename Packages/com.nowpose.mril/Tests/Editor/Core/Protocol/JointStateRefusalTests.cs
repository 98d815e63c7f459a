using System.Linq;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Tests.Core.Protocol.RosbridgeTexts;

namespace Nowpose.Tests.Core.Protocol
{
    /// <summary>Checks the limits of joint state messages and the reasons for which such messages are rejected.</summary>
    public class JointStateRefusalTests
    {
        [TestCase("NaN")]
        [TestCase("Infinity")]
        [TestCase("-Infinity")]
        [TestCase("null")]
        public void TryRead_PositionNotFinite_IsRefused(string position) =>
            Refuse(State("[\"a\"]", "[" + position + "]"), DropReason.NotFinite);

        [Test]
        public void TryRead_PositionBeyondTheRangeOfDouble_IsRefused()
        {
            var isRead = RosbridgeReader.TryRead(State("[\"a\"]", "[1e999]"), out _, out var reason);

            Assert.That(isRead, Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.NotFinite).Or.EqualTo(DropReason.OutOfRange));
        }

        [Test]
        public void TryRead_IntegerWithAThousandDigits_IsRefused() =>
            Assert.That(RosbridgeReader.TryRead(State("[\"a\"]", "[" + new string('9', 1000) + "]"), out _, out _), Is.False);

        [TestCase("[\"a\",\"b\"]", "[1]", "")]
        [TestCase("[\"a\"]", "[1,2]", "")]
        [TestCase("[\"a\"]", "[]", "")]
        [TestCase("[\"a\"]", "[1]", ",\"velocity\":[1,2]")]
        public void TryRead_UnequalLengths_IsRefused(string name, string position, string rest) =>
            Refuse(State(name, position, rest), DropReason.LengthMismatch);

        [TestCase("[\"a\"]", "[\"1\"]", "")]
        [TestCase("[\"a\"]", "[true]", "")]
        [TestCase("[\"a\"]", "1", "")]
        [TestCase("[1]", "[1]", "")]
        [TestCase("[null]", "[1]", "")]
        [TestCase("[\"a\"]", "[[1]]", "")]
        [TestCase("[\"a\"]", "[1]", ",\"velocity\":[\"x\"]")]
        [TestCase("[\"a\"]", "[1]", ",\"velocity\":0")]
        public void TryRead_WrongJsonType_IsRefused(string name, string position, string rest) =>
            Refuse(State(name, position, rest), DropReason.WrongType);

        [Test]
        public void TryRead_VelocityInfinite_IsRefused() =>
            Refuse(State("[\"a\"]", "[1]", ",\"velocity\":[Infinity]"), DropReason.NotFinite);

        // The field is not part of sensor_msgs/JointState.
        [TestCase("0")]
        [TestCase("[\"x\"]")]
        [TestCase("[[1]]")]
        [TestCase("{\"a\":[1]}")]
        [TestCase("[1,2]")]
        [TestCase("[Infinity]")]
        public void TryRead_InvalidAcceleration_IsReadAsAbsent(string acceleration)
        {
            var state = Read(State("[\"a\"]", "[1]", ",\"acceleration\":" + acceleration + ",\"velocity\":[2]")).JointState;

            Assert.That((state.Positions[0], state.Velocities[0], state.Accelerations), Is.EqualTo((1.0, 2.0, default(double[]))));
        }

        [Test]
        public void TryRead_AccelerationIsNotJson_IsRefused() =>
            Refuse(State("[\"a\"]", "[1]", ",\"acceleration\":[1 2]"), DropReason.NotJson);

        [TestCase(256, true)]
        [TestCase(257, false)]
        public void TryRead_JointCount_IsLimitedTo256(int count, bool expected)
        {
            var names = "[" + string.Join(",", Enumerable.Range(0, count).Select(i => "\"j" + i + "\"")) + "]";
            var text = State(names, "[" + string.Join(",", Enumerable.Repeat("0", count)) + "]");

            if (expected) Assert.That(Read(text).JointState.Names.Length, Is.EqualTo(count));
            else Refuse(text, DropReason.TooManyJoints);
        }

        [TestCase(128, true)]
        [TestCase(129, false)]
        public void TryRead_NameLength_IsLimitedTo128Characters(int length, bool expected)
        {
            var text = State("[\"" + new string('n', length) + "\"]", "[0]");

            if (expected) Assert.That(Read(text).JointState.Names[0].Length, Is.EqualTo(length));
            else Refuse(text, DropReason.NameTooLong);
        }

        [Test]
        public void TryRead_DuplicateName_IsRefused() => Refuse(State("[\"a\",\"b\",\"a\"]", "[1,2,3]"), DropReason.DuplicateName);

        [Test]
        public void TryRead_WithoutJoints_IsRefused() => Refuse(State("[]", "[]"), DropReason.MissingField);

        [Test]
        public void TryRead_EmptyName_IsRefused() => Refuse(State("[\"\"]", "[1]"), DropReason.MissingField);

        [TestCase("{\"sec\":0,\"nanosec\":0}", DropReason.StampZero)]
        [TestCase("{\"secs\":0,\"nsecs\":0}", DropReason.StampZero)]
        [TestCase("{\"sec\":1,\"nanosec\":1000000000}", DropReason.StampOutOfRange)]
        [TestCase("{\"sec\":1,\"nanosec\":-1}", DropReason.StampOutOfRange)]
        [TestCase("{\"sec\":-1,\"nanosec\":1}", DropReason.StampOutOfRange)]
        [TestCase("{\"sec\":4294967296,\"nanosec\":0}", DropReason.StampOutOfRange)]
        [TestCase("{\"sec\":99999999999999999999,\"nanosec\":0}", DropReason.OutOfRange)]
        [TestCase("{\"sec\":1.5,\"nanosec\":0}", DropReason.WrongType)]
        [TestCase("{\"sec\":\"1\",\"nanosec\":0}", DropReason.WrongType)]
        [TestCase("{\"sec\":1}", DropReason.MissingField)]
        [TestCase("{\"sec\":1,\"nsecs\":0}", DropReason.DuplicateField)]
        [TestCase("{}", DropReason.MissingField)]
        [TestCase("null", DropReason.WrongType)]
        public void TryRead_InvalidStamp_ReturnsTheReason(string stamp, object expected) =>
            Refuse(Publish("{\"header\":{\"stamp\":" + stamp + "},\"name\":[],\"position\":[]}"), (DropReason)expected);

        [TestCase("{\"sec\":4294967295,\"nanosec\":999999999}", 4_294_967_296_000_000_000)]
        [TestCase("{\"sec\":0,\"nanosec\":100}", 100)]
        public void TryRead_StampAtTheLimit_IsRead(string stamp, long expectedNs)
        {
            var state = Read(Publish("{\"header\":{\"stamp\":" + stamp + "},\"name\":[\"a\"],\"position\":[1]}")).JointState;

            Assert.That(state.Stamp.Nanoseconds, Is.EqualTo(expectedNs));
        }
    }
}
