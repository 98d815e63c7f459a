using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Tests.Core.Protocol.RosbridgeTexts;

namespace Nowpose.Tests.Core.Protocol
{
    /// <summary>Checks the values that are read from messages, and the fields of each operation.</summary>
    public class RosbridgeReaderTests
    {
        [Test]
        public void TryRead_JointState_ReturnsItsValues()
        {
            var state = Read(State("[\"a\",\"b\"]", "[1.5,-2]", ",\"velocity\":[0.25,null],\"effort\":[]")).JointState;

            Assert.That(state.Stamp, Is.EqualTo(ControlTime.FromNanoseconds(12_345_678_900)));
            Assert.That(state.Names, Is.EqualTo(new[] { "a", "b" }));
            Assert.That(state.Positions, Is.EqualTo(new[] { 1.5, -2 }));
            Assert.That(state.Velocities, Is.EqualTo(new[] { 0.25, double.NaN }));
        }

        [Test]
        public void TryRead_Ros1Time_ReturnsTheSameStamp()
        {
            var text = State("[\"a\"]", "[1]").Replace("\"sec\"", "\"secs\"").Replace("\"nanosec\"", "\"nsecs\"");

            Assert.That(Read(text).JointState.Stamp, Is.EqualTo(ControlTime.FromNanoseconds(12_345_678_900)));
        }

        [TestCase(",\"velocity\":[]")]
        [TestCase(",\"velocity\":null")]
        [TestCase("")]
        public void TryRead_WithoutVelocity_ReturnsNullVelocities(string rest) =>
            Assert.That(Read(State("[\"a\"]", "[1]", rest)).JointState.Velocities, Is.Null);

        [TestCase("[NaN]")]
        [TestCase("[null,null,null]")]
        [TestCase("[-Infinity]")]
        [TestCase("\"none\"")]
        [TestCase("{\"a\":[1,{\"b\":null}]}")]
        public void TryRead_AnyEffort_IsIgnored(string effort) =>
            Assert.That(Read(State("[\"a\"]", "[1]", ",\"effort\":" + effort)).JointState.Positions, Is.EqualTo(new[] { 1.0 }));

        [Test]
        public void TryRead_BodyBeforeTopicAndOp_IsRead()
        {
            var text = "{\"msg\":{" + Stamp + ",\"position\":[1],\"name\":[\"a\"]},\"topic\":\"/joint_states\",\"op\":\"publish\"}";

            Assert.That(Read(text).JointState.Names, Is.EqualTo(new[] { "a" }));
        }

        [Test]
        public void TryRead_UnknownFields_AreSkipped()
        {
            var text = State("[\"a\"]", "[1]", ",\"extra\":{\"name\":[1],\"position\":{}}").Replace("{\"op\"", "{\"latch\":[{}],\"op\"");

            Assert.That(Read(text).JointState.Names, Is.EqualTo(new[] { "a" }));
        }

        [Test]
        public void TryRead_NameLooksLikeADate_IsNotConverted() =>
            Assert.That(Read(State("[\"2024-01-01T00:00:00Z\"]", "[1]")).JointState.Names[0], Is.EqualTo("2024-01-01T00:00:00Z"));

        [TestCase("{\"topic\":\"/a\"}")]
        [TestCase("{\"op\":\"subscribe\"}")]
        [TestCase("{\"op\":\"subscribe\",\"topic\":\"\"}")]
        [TestCase("{\"op\":\"unadvertise\",\"topic\":null}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/joint_states\"}")]
        [TestCase("{\"op\":\"publish\",\"msg\":{}}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":{}}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/robot_description\",\"msg\":{}}")]
        [TestCase("{\"op\":\"call_service\"}")]
        [TestCase("{\"op\":\"service_response\",\"result\":true}")]
        [TestCase("{\"op\":\"status\",\"level\":\"error\"}")]
        public void TryRead_FieldMissing_IsRefused(string text) => Refuse(text, DropReason.MissingField);

        [TestCase("{\"op\":1}")]
        [TestCase("{\"op\":null}")]
        [TestCase("{\"op\":\"subscribe\",\"topic\":7}")]
        [TestCase("{\"op\":\"subscribe\",\"topic\":\"/a\",\"throttle_rate\":\"fast\"}")]
        [TestCase("{\"op\":\"subscribe\",\"topic\":\"/a\",\"queue_length\":1.5}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":[]}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":\"x\"}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/robot_description\",\"msg\":{\"data\":1}}")]
        public void TryRead_EnvelopeOfWrongType_IsRefused(string text) => Refuse(text, DropReason.WrongType);

        [TestCase("-1")]
        [TestCase("2147483648")]
        public void TryRead_CountOutOfRange_IsRefused(string rate) =>
            Refuse("{\"op\":\"subscribe\",\"topic\":\"/a\",\"throttle_rate\":" + rate + "}", DropReason.OutOfRange);

        [TestCase("{\"op\":\"status\",\"op\":\"status\",\"msg\":\"a\"}")]
        [TestCase("{\"op\":\"publish\",\"topic\":\"/joint_states\",\"msg\":{},\"msg\":{}}")]
        public void TryRead_DuplicateKnownField_IsRefused(string text) => Refuse(text, DropReason.DuplicateField);

        [TestCase("7")]
        [TestCase("-9223372036854775808")]
        public void TryRead_IntegerId_IsWrittenAsANumberAgain(string id)
        {
            var message = Read("{\"op\":\"call_service\",\"service\":\"/a\",\"id\":" + id + "}");

            Assert.That(RosbridgeWriter.CallService("/a", message.Id), Does.Contain("\"id\":" + id + ","));
            Assert.That(message.Id == (RequestId)id, Is.False, "a string is another id");
        }

        [TestCase("1.5", DropReason.WrongType)]
        [TestCase("true", DropReason.WrongType)]
        [TestCase("NaN", DropReason.WrongType)]
        [TestCase("9223372036854775808", DropReason.OutOfRange)]
        public void TryRead_IdNeitherAStringNorAnInteger_IsRefused(string id, object reason) =>
            Refuse("{\"op\":\"call_service\",\"service\":\"/a\",\"id\":" + id + "}", (DropReason)reason);

        [TestCase("\"id\":\"7\",", "7")]
        [TestCase("\"id\":7,", "7")]
        [TestCase("\"id\":7.5,", "")]
        [TestCase("", "")]
        public void TryRead_UnreadableOption_ReturnsOperationTopicAndId(string id, string expected)
        {
            var isRead = RosbridgeReader.TryRead("{\"op\":\"subscribe\",\"queue_length\":-1," + id + "\"topic\":\"/tf\"}", out var message, out _);

            Assert.That(isRead, Is.False);
            Assert.That((message.OpName, message.Topic, message.Id.ToString()), Is.EqualTo(("subscribe", "/tf", expected)));
            Assert.That(message.Op, Is.EqualTo(RosbridgeOp.Unknown), "the request is not read");
        }

        [Test]
        public void TryRead_UnknownOp_ReturnsItsNameAndId()
        {
            var isRead = RosbridgeReader.TryRead("{\"op\":\"dance\",\"id\":\"7\"}", out var message, out var reason);

            Assert.That(isRead, Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.UnknownOp));
            Assert.That(message.OpName, Is.EqualTo("dance"));
            Assert.That(message.Id.Text, Is.EqualTo("7"));
        }

        [Test]
        public void TryRead_FailedServiceCall_ReturnsFalseWithoutATime()
        {
            var text = "{\"op\":\"service_response\",\"service\":\"/rosapi/get_time\",\"values\":\"no such service\",\"result\":false}";

            var message = Read(text);

            Assert.That(message.Result, Is.False);
            Assert.That(message.Time, Is.Null);
        }

        // Controllers of ROS also have topics named joint_trajectory, and are not robots.
        [TestCase("\"/joint_states\",\"/arm2/joint_states\",\"/arm2/joint_trajectory\",\"/arm1/joint_states\"", new[] { "arm1", "arm2" })]
        [TestCase("\"/controller/joint_trajectory\",\"/a/b/joint_states\",\"/tf\",\"\"", new string[0])]
        [TestCase("", new string[0])]
        public void TryRead_ListOfTopics_HasTheNamespacesOfTheRobots(string topics, string[] expected) =>
            Assert.That(Read(TopicsOf("[" + topics + "]")).Namespaces, Is.EqualTo(expected));

        [TestCase("[1]")]
        [TestCase("\"/arm1/joint_states\"")]
        public void TryRead_ListOfTopicsOfWrongType_IsRefused(string topics) => Refuse(TopicsOf(topics), DropReason.WrongType);

        static string TopicsOf(string topics) =>
            "{\"op\":\"service_response\",\"service\":\"/rosapi/topics\",\"values\":{\"topics\":" + topics + ",\"types\":[]},\"result\":true}";

        [Test]
        public void TryRead_DiagnosticsWithoutExactlyOneStatus_IsRefused()
        {
            const string Status = "{\"hardware_id\":\"a\",\"values\":[]}";

            Read(Publish("{\"status\":[" + Status + "]}", "/nowpose/diagnostics"));
            Refuse(Publish("{\"status\":[" + Status + "," + Status + "]}", "/nowpose/diagnostics"), DropReason.LengthMismatch);
            Refuse(Publish("{\"status\":[]}", "/nowpose/diagnostics"), DropReason.LengthMismatch);
        }
    }
}
