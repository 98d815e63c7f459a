using System.Linq;
using System.Text;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol.Cell
{
    public class SignalsReaderTests
    {
        static string Publish(string names, string values, string stamp = "{\"sec\":12,\"nanosec\":345678900}") =>
            "{\"op\":\"publish\",\"topic\":\"/signals\",\"msg\":{\"header\":{\"stamp\":" + stamp + ",\"frame_id\":\"\"},\"name\":" + names
            + ",\"value\":" + values + "}}";

        static SignalsMessage Read(string text)
        {
            Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, reason.ToString());
            return message.Signals;
        }

        static void Refuse(string text, DropReason expected)
        {
            Assert.That(RosbridgeReader.TryRead(text, out _, out var reason), Is.False, text);
            Assert.That(reason, Is.EqualTo(expected));
        }

        [TestCase("{\"sec\":12,\"nanosec\":345678900}")]
        [TestCase("{\"secs\":12,\"nsecs\":345678900}")]
        public void TryRead_Signals_ReturnsTheirValues(string stamp)
        {
            var read = Read(Publish("[\"grip\",\"belt.speed\"]", "[1,-0.25]", stamp));

            Assert.That(read.Stamp, Is.EqualTo(ControlTime.FromNanoseconds(12_345_678_900)));
            Assert.That(read.Count, Is.EqualTo(2));
            Assert.That(new[] { read[0].Name, read[1].Name }, Is.EqualTo(new[] { "grip", "belt.speed" }));
            Assert.That(new[] { read[0].Value, read[1].Value }, Is.EqualTo(new[] { 1, -0.25 }));
        }

        [TestCase("[\"a\"]", "[NaN]", DropReason.NotFinite)]
        [TestCase("[\"a\"]", "[null]", DropReason.NotFinite)]
        [TestCase("[\"a\"]", "[Infinity]", DropReason.NotFinite)]
        [TestCase("[\"a\"]", "[true]", DropReason.WrongType)]
        [TestCase("[\"a\"]", "[\"1\"]", DropReason.WrongType)]
        [TestCase("[\"a\"]", "1", DropReason.WrongType)]
        [TestCase("[1]", "[1]", DropReason.WrongType)]
        [TestCase("[\"a\",\"b\"]", "[1]", DropReason.LengthMismatch)]
        [TestCase("[\"a\"]", "[]", DropReason.LengthMismatch)]
        [TestCase("[]", "[1]", DropReason.LengthMismatch)]
        [TestCase("[]", "[]", DropReason.MissingField)]
        [TestCase("[\"\"]", "[1]", DropReason.MissingField)]
        [TestCase("[\"a\",\"b\",\"a\"]", "[1,2,3]", DropReason.DuplicateName)]
        public void TryRead_InvalidSignals_AreRefused(string names, string values, object expected) =>
            Refuse(Publish(names, values), (DropReason)expected);

        [TestCase("{\"sec\":0,\"nanosec\":0}", DropReason.StampZero)]
        [TestCase("{\"secs\":1,\"nsecs\":1000000000}", DropReason.StampOutOfRange)]
        [TestCase("{}", DropReason.MissingField)]
        public void TryRead_InvalidStamp_ReturnsTheReason(string stamp, object expected) =>
            Refuse(Publish("[\"a\"]", "[1]", stamp), (DropReason)expected);

        [TestCase("\"name\":[\"a\"],\"value\":[1]")]
        [TestCase("\"header\":{\"stamp\":{\"sec\":1,\"nanosec\":0}},\"value\":[1]")]
        [TestCase("\"header\":{\"stamp\":{\"sec\":1,\"nanosec\":0}},\"name\":[\"a\"]")]
        public void TryRead_FieldMissing_IsRefused(string fields) =>
            Refuse("{\"op\":\"publish\",\"topic\":\"/signals\",\"msg\":{" + fields + "}}", DropReason.MissingField);

        [TestCase(256, true)]
        [TestCase(257, false)]
        public void TryRead_SignalCount_IsLimitedTo256(int count, bool expected)
        {
            var names = "[" + string.Join(",", Enumerable.Range(0, count).Select(i => "\"s" + i + "\"")) + "]";
            var text = Publish(names, "[" + string.Join(",", Enumerable.Repeat("0", count)) + "]");

            if (expected) Assert.That(Read(text).Count, Is.EqualTo(count));
            else Refuse(text, DropReason.TooManySignals);
        }

        [TestCase(128, true)]
        [TestCase(129, false)]
        public void TryRead_NameLength_IsLimitedTo128Characters(int length, bool expected)
        {
            var text = Publish("[\"" + new string('n', length) + "\"]", "[0]");

            if (expected) Assert.That(Read(text)[0].Name.Length, Is.EqualTo(length));
            else Refuse(text, DropReason.NameTooLong);
        }

        [TestCase(RosTimeForm.Sec)]
        [TestCase(RosTimeForm.Secs)]
        public void PublishSignals_ReadBack_RoundTrips(object form)
        {
            var sent = new SignalsMessage(
                ControlTime.FromNanoseconds(12_345_678_900), new SignalValue("grip", 1), new SignalValue("é\"", 1.0 / 3));

            var text = RosbridgeWriter.Publish("/signals", sent, (RosTimeForm)form);

            Assert.That(text.Contains("\"secs\":"), Is.EqualTo((RosTimeForm)form == RosTimeForm.Secs));
            var read = Read(text);
            Assert.That(read.Stamp, Is.EqualTo(sent.Stamp));
            Assert.That(new[] { read[0].Name, read[1].Name }, Is.EqualTo(new[] { "grip", "é\"" }));
            Assert.That(new[] { read[0].Value, read[1].Value }, Is.EqualTo(new[] { 1, 1.0 / 3 }));
        }

        [Test]
        public void PublishSignals_ValueNotFinite_IsRefused() => Assert.Throws<System.ArgumentException>(() => RosbridgeWriter.Publish(
            "/signals", new SignalsMessage(ControlTime.FromSeconds(1), new SignalValue("a", double.NaN)), RosTimeForm.Sec));

        [Test]
        public void TryRead_MessageReleased_IsReusedWithoutPreviousValues()
        {
            var reader = new RosbridgeReader();
            var first = ReadWith(reader, Publish("[\"a\",\"b\"]", "[1,2]"));
            first.Release();

            var second = ReadWith(reader, Publish("[\"b\"]", "[3]"));

            Assert.That(second, Is.SameAs(first));
            Assert.That(second.Count, Is.EqualTo(1));
            Assert.That(second[0].Name, Is.EqualTo("b"));
            Assert.That(second[0].Value, Is.EqualTo(3));
        }

        static SignalsMessage ReadWith(RosbridgeReader reader, string text)
        {
            Assert.That(reader.TryRead(Encoding.UTF8.GetBytes(text), out var message, out var reason), Is.True, reason.ToString());
            return message.Signals;
        }
    }
}
