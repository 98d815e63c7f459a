using System;
using System.Linq;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class RosbridgeReaderTests
    {
        const string Stamp = "\"header\":{\"stamp\":{\"sec\":12,\"nanosec\":345678900},\"frame_id\":\"\"}";

        static string Publish(string msg, string topic = "/joint_states") =>
            "{\"op\":\"publish\",\"topic\":\"" + topic + "\",\"msg\":" + msg + "}";

        static string State(string name, string position, string rest = "") =>
            Publish("{" + Stamp + ",\"name\":" + name + ",\"position\":" + position + rest + "}");

        static RosbridgeMessage Read(string text)
        {
            var isRead = RosbridgeReader.TryRead(text, out var message, out var reason);
            Assert.That(isRead, Is.True, reason + ": " + text.Substring(0, System.Math.Min(200, text.Length)));
            Assert.That(reason, Is.EqualTo(DropReason.None));
            return message;
        }

        static void Refuse(string text, DropReason expected)
        {
            Assert.That(RosbridgeReader.TryRead(text, out _, out var reason), Is.False, text.Substring(0, System.Math.Min(200, text.Length)));
            Assert.That(reason, Is.EqualTo(expected));
        }

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
        public void TryRead_Ros1Time_IsTheSameStamp()
        {
            var text = State("[\"a\"]", "[1]").Replace("\"sec\"", "\"secs\"").Replace("\"nanosec\"", "\"nsecs\"");

            Assert.That(Read(text).JointState.Stamp, Is.EqualTo(ControlTime.FromNanoseconds(12_345_678_900)));
        }

        [TestCase(",\"velocity\":[]")]
        [TestCase(",\"velocity\":null")]
        [TestCase("")]
        public void TryRead_NoVelocity_IsNull(string rest) =>
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
        public void TryRead_TextLikeADate_IsUnchanged() =>
            Assert.That(Read(State("[\"2024-01-01T00:00:00Z\"]", "[1]")).JointState.Names[0], Is.EqualTo("2024-01-01T00:00:00Z"));

        [TestCase("")]
        [TestCase(" ")]
        [TestCase("[]")]
        [TestCase("1")]
        [TestCase("null")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\"} {}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\"}x")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\"")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",}")]
        [TestCase("{\"op\":\"status\",,\"msg\":\"a\"}")]
        [TestCase("{'op':\"status\",\"msg\":\"a\"}")]
        [TestCase("{op:\"status\",\"msg\":\"a\"}")]
        [TestCase("{\"op\":'status',\"msg\":\"a\"}")]
        [TestCase("{\"op\":\"status\",/*c*/\"msg\":\"a\"}")]
        [TestCase("//c\n{\"op\":\"status\",\"msg\":\"a\"}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":[1,]}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":[,1]}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":0x10}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":010}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":.5}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":+5}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":5.}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":1e}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":undefined}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":new Date(1)}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\",\"x\":[1}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"\\q\"}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"\\u12g4\"}")]
        [TestCase("{\"op\":\"status\",\"msg\":\"a\nb\"}")]
        [TestCase("\uFEFF{\"op\":\"status\",\"msg\":\"a\"}")]
        public void TryRead_NotStrictlyOneJsonObject_IsRefused(string text) => Refuse(text, DropReason.NotJson);

        [TestCase("NaN")]
        [TestCase("Infinity")]
        [TestCase("-Infinity")]
        [TestCase("null")]
        public void TryRead_PositionNotFinite_IsRefused(string position) =>
            Refuse(State("[\"a\"]", "[" + position + "]"), DropReason.NotFinite);

        [Test]
        public void TryRead_PositionBeyondDouble_IsRefused()
        {
            var isRead = RosbridgeReader.TryRead(State("[\"a\"]", "[1e999]"), out _, out var reason);

            Assert.That(isRead, Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.NotFinite).Or.EqualTo(DropReason.OutOfRange));
        }

        [Test]
        public void TryRead_IntegerOfThousandDigits_IsRefused() =>
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

        [TestCase(256, true)]
        [TestCase(257, false)]
        public void TryRead_Joints_AreReadUpTo256(int count, bool expected)
        {
            var names = "[" + string.Join(",", Enumerable.Range(0, count).Select(i => "\"j" + i + "\"")) + "]";
            var text = State(names, "[" + string.Join(",", Enumerable.Repeat("0", count)) + "]");

            if (expected) Assert.That(Read(text).JointState.Names.Length, Is.EqualTo(count));
            else Refuse(text, DropReason.TooManyJoints);
        }

        [TestCase(128, true)]
        [TestCase(129, false)]
        public void TryRead_Name_IsReadUpTo128Characters(int length, bool expected)
        {
            var text = State("[\"" + new string('n', length) + "\"]", "[0]");

            if (expected) Assert.That(Read(text).JointState.Names[0].Length, Is.EqualTo(length));
            else Refuse(text, DropReason.NameTooLong);
        }

        [Test]
        public void TryRead_NameTwice_IsRefused() => Refuse(State("[\"a\",\"b\",\"a\"]", "[1,2,3]"), DropReason.DuplicateName);

        [Test]
        public void TryRead_NoJoint_IsRefused() => Refuse(State("[]", "[]"), DropReason.MissingField);

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
        public void TryRead_StampAtTheEdge_IsRead(string stamp, long expectedNs)
        {
            var state = Read(Publish("{\"header\":{\"stamp\":" + stamp + "},\"name\":[\"a\"],\"position\":[1]}")).JointState;

            Assert.That(state.Stamp.Nanoseconds, Is.EqualTo(expectedNs));
        }

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
        public void TryRead_KnownFieldTwice_IsRefused(string text) => Refuse(text, DropReason.DuplicateField);

        [Test]
        public void TryRead_UnknownOp_KeepsItsNameAndId()
        {
            var isRead = RosbridgeReader.TryRead("{\"op\":\"dance\",\"id\":\"7\"}", out var message, out var reason);

            Assert.That(isRead, Is.False);
            Assert.That(reason, Is.EqualTo(DropReason.UnknownOp));
            Assert.That(message.OpName, Is.EqualTo("dance"));
            Assert.That(message.Id, Is.EqualTo("7"));
        }

        [TestCase(14, true)]
        [TestCase(15, false)]
        [TestCase(10_000, false)]
        public void TryRead_Nesting_IsReadUpTo16Levels(int inside, bool expected)
        {
            // The message and its msg object add two levels.
            var nested = new string('[', inside) + new string(']', inside);
            var text = State("[\"a\"]", "[1]", ",\"effort\":" + nested);

            if (expected) Read(text);
            else Refuse(text, DropReason.TooDeep);
        }

        [Test]
        public void TryRead_UnclosedNestingOf10000_IsTooDeep() =>
            Refuse("{\"op\":" + string.Concat(Enumerable.Repeat("{\"a\":[", 10_000)), DropReason.TooDeep);

        [TestCase("x", 0, true)]
        [TestCase("x", 1, false)]
        [TestCase("é", 0, true)]
        [TestCase("é", 1, false)]
        public void TryRead_Message_IsReadUpTo64KiBOfUtf8(string character, int over, bool expected)
        {
            var text = Sized(character, 64 * 1024 + over, "/joint_states", "name");

            if (expected) Read(text);
            else Refuse(text, DropReason.TooLarge);
        }

        [TestCase(0, true)]
        [TestCase(1, false)]
        public void TryRead_LongDescription_IsLimitedTo1MiB(int over, bool expected)
        {
            var text = Sized("x", 1024 * 1024 + over, "/robot_description", "data");

            if (expected) Assert.That(Read(text).Data.Length, Is.GreaterThan(1_000_000));
            else Refuse(text, DropReason.TooLarge);
        }

        // A message of exactly this size in bytes, filled up in an unused field or in the data.
        static string Sized(string character, int bytes, string topic, string field)
        {
            string Make(string fill) => field == "data"
                ? Publish("{\"data\":\"" + fill + "\"}", topic)
                : State("[\"a\"]", "[1]", ",\"fill\":\"" + fill + "\"");

            var room = bytes - System.Text.Encoding.UTF8.GetByteCount(Make(""));
            var width = System.Text.Encoding.UTF8.GetByteCount(character);
            var fill = string.Concat(Enumerable.Repeat(character, room / width)) + new string('x', room % width);
            return Make(fill);
        }

        [Test]
        public void TryRead_DamagedMessages_NeverThrows()
        {
            const int Seed = 3;
            const string Alphabet = "{}[]\",:0123456789.eE+-\\/ntfuNI*' \0\uD800x";
            var random = new System.Random(Seed);
            var whole = State("[\"a\",\"b\"]", "[1.5,-2e3]", ",\"velocity\":[0.25,null],\"effort\":[NaN]");
            var refused = 0;
            for (var i = 0; i < 20_000; i++)
            {
                var damaged = whole.ToCharArray();
                for (var n = random.Next(1, 4); n > 0; n--)
                    damaged[random.Next(damaged.Length)] = Alphabet[random.Next(Alphabet.Length)];
                var text = new string(damaged, 0, random.Next(8) == 0 ? random.Next(damaged.Length) : damaged.Length);

                Assert.DoesNotThrow(() => refused += RosbridgeReader.TryRead(text, out _, out _) ? 0 : 1, text + ", seed " + Seed);
            }

            Assert.That(refused, Is.GreaterThan(10_000));
        }

        [Test]
        public void TryRead_FailedServiceCall_HasNoTimeOrResult()
        {
            var text = "{\"op\":\"service_response\",\"service\":\"/rosapi/get_time\",\"values\":\"no such service\",\"result\":false}";

            var message = Read(text);

            Assert.That(message.Result, Is.False);
            Assert.That(message.Time, Is.Null);
        }

        [Test]
        public void TryRead_DiagnosticsOfTwoHeadsets_IsRefused()
        {
            const string Status = "{\"hardware_id\":\"a\",\"values\":[]}";

            Read(Publish("{\"status\":[" + Status + "]}", "/nowpose/diagnostics"));
            Refuse(Publish("{\"status\":[" + Status + "," + Status + "]}", "/nowpose/diagnostics"), DropReason.LengthMismatch);
            Refuse(Publish("{\"status\":[]}", "/nowpose/diagnostics"), DropReason.LengthMismatch);
        }

        [Test]
        public void TryRead_TrajectoryPointOfOtherLength_IsRefused()
        {
            const string Point = "{\"positions\":[1,2],\"time_from_start\":{\"sec\":0,\"nanosec\":0}}";

            Refuse(Publish("{" + Stamp + ",\"joint_names\":[\"a\"],\"points\":[" + Point + "]}", "/joint_trajectory"), DropReason.LengthMismatch);
        }

        static string TrajectoryPoint(double seconds, string more = "") => FormattableString.Invariant(
            $"{{\"positions\":[1],\"time_from_start\":{{\"sec\":{Math.Floor(seconds)},\"nanosec\":{(seconds - Math.Floor(seconds)) * 1e9}}}{more}}}");

        static string Trajectory(params string[] points) => Publish(
            "{" + Stamp + ",\"joint_names\":[\"a\"],\"points\":[" + string.Join(",", points) + "]}", "/joint_trajectory");

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

        [TestCase(",\"accelerations\":[1,2]")]
        [TestCase(",\"velocities\":[1,2]")]
        public void TryRead_TrajectoryFieldOfOtherLength_IsRefused(string more)
        {
            Refuse(Trajectory(TrajectoryPoint(0, more)), DropReason.LengthMismatch);
        }
    }
}
