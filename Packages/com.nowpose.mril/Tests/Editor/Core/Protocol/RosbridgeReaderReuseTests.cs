using System;
using System.Linq;
using System.Text;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol
{
    /// <summary>Checks the state that a reader keeps from one message to the next.</summary>
    public class RosbridgeReaderReuseTests
    {
        readonly RosbridgeReader _reader = new RosbridgeReader();

        static string State(string names, string positions, string rest = "", string topic = "/joint_states") =>
            "{\"op\":\"publish\",\"topic\":\"" + topic + "\",\"msg\":{\"header\":{\"stamp\":{\"sec\":12,\"nanosec\":0},\"frame_id\":\"h\"},\"name\":"
            + names + ",\"position\":" + positions + rest + "}}";

        JointStateMessage Read(string text)
        {
            Assert.That(_reader.TryRead(Encoding.UTF8.GetBytes(text), out var message, out var reason), Is.True, reason + ": " + text);
            return message.JointState;
        }

        [Test]
        public void TryRead_SameNames_ReusesTheArray()
        {
            var arm = Read(State("[\"a\",\"b\"]", "[1,2]")).Names;
            var gripper = Read(State("[\"g\"]", "[3]")).Names;

            Assert.That(Read(State("[\"a\",\"b\"]", "[4,5]")).Names, Is.SameAs(arm));
            Assert.That(Read(State("[\"g\"]", "[6]")).Names, Is.SameAs(gripper));
        }

        [TestCase("[\"a\",\"b\",\"c\"]", "a b c")]
        [TestCase("[\"a\"]", "a")]
        [TestCase("[\"a\",\"c\"]", "a c")]
        [TestCase("[ \"a\",\"b\"]", "a b")]
        [TestCase("[\"\\u0061\",\"b\"]", "a b")]
        public void TryRead_OtherNames_ReturnsTheNamesOfTheMessage(string names, string expected)
        {
            Read(State("[\"a\",\"b\"]", "[1,2]"));
            var count = expected.Split(' ').Length;

            var state = Read(State(names, "[" + string.Join(",", Enumerable.Range(0, count)) + "]"));

            Assert.That(string.Join(" ", state.Names), Is.EqualTo(expected));
        }

        [Test]
        public void TryRead_MoreSourcesThanTheCacheHolds_AreAllRead()
        {
            for (var round = 0; round < 3; round++)
            {
                for (var i = 0; i < 10; i++) Assert.That(Read(State("[\"j" + i + "\"]", "[1]")).Names, Is.EqualTo(new[] { "j" + i }));
            }
        }

        [Test]
        public void TryRead_MessageNotReleased_IsUnchanged()
        {
            var first = Read(State("[\"a\",\"b\"]", "[1,2]", ",\"velocity\":[3,4]"));

            var second = Read(State("[\"a\",\"b\"]", "[5,6]"));

            Assert.That(second, Is.Not.SameAs(first));
            Assert.That(first.Positions, Is.EqualTo(new[] { 1.0, 2.0 }));
            Assert.That(first.Velocities, Is.EqualTo(new[] { 3.0, 4.0 }));
        }

        [Test]
        public void TryRead_MessageReleased_IsReusedWithoutPreviousValues()
        {
            var first = Read(State("[\"a\",\"b\"]", "[1,2]", ",\"velocity\":[3,4],\"acceleration\":[5,null]"));
            var positions = first.Positions;
            first.Release();

            var second = Read(State("[\"c\",\"d\"]", "[5,6]"));

            Assert.That(second, Is.SameAs(first));
            Assert.That(second.Positions, Is.SameAs(positions));
            Assert.That(second.Names, Is.EqualTo(new[] { "c", "d" }));
            Assert.That(second.Positions, Is.EqualTo(new[] { 5.0, 6.0 }));
            Assert.That(second.Velocities, Is.Null);
            Assert.That(second.Accelerations, Is.Null);
        }

        [Test]
        public void TryRead_MessagesOfSeveralSizesReleased_ReusesTheMatchingOne()
        {
            var arm = Read(State("[\"a\",\"b\"]", "[1,2]"));
            var gripper = Read(State("[\"g\"]", "[3]"));
            arm.Release();
            gripper.Release();

            Assert.That(Read(State("[\"g\"]", "[4]")), Is.SameAs(gripper));
            Assert.That(Read(State("[\"a\",\"b\"]", "[5,6]")), Is.SameAs(arm));
            Assert.That(Read(State("[\"x\",\"y\",\"z\"]", "[5,6,7]")).Positions, Is.EqualTo(new[] { 5.0, 6.0, 7.0 }));
        }

        [Test]
        public void Release_MessageNotFromAReader_HasNoEffect() =>
            Assert.DoesNotThrow(new JointStateMessage(ControlTime.FromSeconds(1), new[] { "a" }, new[] { 1.0 }).Release);

        [Test]
        public void TryRead_OtherOperation_HasNoPreviousValues()
        {
            Read(State("[\"a\"]", "[1]"));

            _reader.TryRead(Encoding.UTF8.GetBytes("{\"op\":\"call_service\",\"service\":\"/x\"}"), out var message, out _);

            Assert.That(message.JointState, Is.Null);
            Assert.That(message.Topic, Is.Null);
            Assert.That(message.Result, Is.True);
        }

        static readonly byte[][] NotUtf8 =
        {
            new byte[] { 0x80 }, new byte[] { 0xC0, 0x80 }, new byte[] { 0xC3 }, new byte[] { 0xE0, 0x80, 0x80 }, new byte[] { 0xED, 0xA0, 0x80 },
            new byte[] { 0xF0, 0x80, 0x80, 0x80 }, new byte[] { 0xF4, 0x90, 0x80, 0x80 }, new byte[] { 0xF5, 0x80, 0x80, 0x80 },
            new byte[] { 0xE2, 0x82 }, new byte[] { 0xFF },
        };

        [Test]
        public void TryRead_InvalidUtf8_IsRefused([ValueSource(nameof(NotUtf8))] byte[] wrong, [Values("name", "unknown", "value")] string place)
        {
            var text = Encoding.UTF8.GetBytes(
                place == "name" ? State("[\"a@\"]", "[1]") : place == "unknown" ? State("[\"a\"]", "[1]", ",\"@\":1") : State("[\"a\"]", "[1]", ",\"x\":\"@\""));
            var at = Array.IndexOf(text, (byte)'@');
            var bytes = text.Take(at).Concat(wrong).Concat(text.Skip(at + 1)).ToArray();

            Assert.That(_reader.TryRead(bytes, out _, out var reason), Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.NotJson));
        }

        [TestCase("é")]
        [TestCase("€")]
        [TestCase("\uFFFF")]
        [TestCase("\U0010FFFF")]
        [TestCase("𝔸𝔹")]
        public void TryRead_NonAsciiName_IsRead(string name) =>
            Assert.That(Read(State("[\"" + name + "\"]", "[1]")).Names[0], Is.EqualTo(name));

        [TestCase("\\\"\\\\\\/\\b\\f\\n\\r\\t", "\"\\/\b\f\n\r\t")]
        [TestCase("a\\u00e9\\u00E9b", "aééb")]
        [TestCase("\\ud83e\\udd16", "\U0001F916")]
        [TestCase("\\ud83e", "\uFFFD")]
        [TestCase("\\udd16x", "\uFFFDx")]
        [TestCase("\\ud83e\\ud83e\\udd16", "\uFFFD\U0001F916")]
        public void TryRead_NameWithEscapes_IsUnescaped(string escaped, string expected) =>
            Assert.That(Read(State("[\"" + escaped + "\"]", "[1]")).Names[0], Is.EqualTo(expected));

        [Test]
        public void TryRead_FieldsAndTopicWithEscapes_AreRecognised()
        {
            var text = State("[\"a\"]", "[1]", topic: "\\/joint\\u005fstates").Replace("\"op\"", "\"\\u006fp\"").Replace("publish", "publi\\u0073h");

            Assert.That(Read(text).Names, Is.EqualTo(new[] { "a" }));
        }

        [Test]
        public void TryRead_DuplicateFieldWithEscapes_IsRefused()
        {
            var text = State("[\"a\"]", "[1]", ",\"p\\u006fsition\":[1]");

            Assert.That(_reader.TryRead(Encoding.UTF8.GetBytes(text), out _, out var reason), Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.DuplicateField));
        }

        [TestCase("[1,2]", "", DropReason.NotJson)]
        [TestCase("[1]", ",\"velocity\":[Infinity]", DropReason.NotJson)]
        [TestCase("[null]", "", DropReason.NotJson)]
        public void TryRead_InvalidBodyInTruncatedText_IsNotJson(string positions, string rest, object expected)
        {
            var text = State("[\"a\"]", positions, rest);

            Assert.That(_reader.TryRead(Encoding.UTF8.GetBytes(text.Substring(0, text.Length - 1)), out _, out var reason), Is.False);
            Assert.That(reason, Is.EqualTo((DropReason)expected));
        }

        [Test]
        public void TryRead_BodyRefused_ReturnsTheEnvelope()
        {
            var text = State("[\"a\"]", "[null]").Replace("[null]}", "[null]},\"id\":\"7\"");

            var isRead = _reader.TryRead(Encoding.UTF8.GetBytes(text), out var message, out var reason);

            Assert.That(isRead, Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.NotFinite));
            Assert.That(message.Id.Text, Is.EqualTo("7"));
        }
    }
}
