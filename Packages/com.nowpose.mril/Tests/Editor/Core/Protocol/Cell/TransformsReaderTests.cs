using System.Globalization;
using System.Linq;
using System.Text;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Protocol.Cell
{
    public class TransformsReaderTests
    {
        const string Stamp = "{\"sec\":12,\"nanosec\":345678900}";
        const string Origin = "{\"x\":0,\"y\":0,\"z\":0}";
        const string NoRotation = "{\"x\":0,\"y\":0,\"z\":0,\"w\":1}";

        static string Transform(
            string child = "box", string parent = "world", string translation = Origin, string rotation = NoRotation, string stamp = Stamp) =>
            "{\"header\":{\"stamp\":" + stamp + ",\"frame_id\":\"" + parent + "\"},\"child_frame_id\":\"" + child
            + "\",\"transform\":{\"translation\":" + translation + ",\"rotation\":" + rotation + "}}";

        static string Publish(string transforms, string topic = "/tf") =>
            "{\"op\":\"publish\",\"topic\":\"" + topic + "\",\"msg\":{\"transforms\":[" + transforms + "]}}";

        static TransformsMessage Read(string text)
        {
            Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, reason.ToString());
            return message.Transforms;
        }

        static void Refuse(string text, DropReason expected)
        {
            Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.False, text);
            Assert.That(reason, Is.EqualTo(expected));
            Assert.That(message == null || message.Transforms == null, Is.True);
        }

        [TestCase("/tf")]
        [TestCase("/tf_static")]
        public void TryRead_Transforms_ReturnsTheirValues(string topic)
        {
            var text = Publish(
                Transform("box", "belt", "{\"x\":1.5,\"y\":-2,\"z\":0.25}", "{\"x\":0.6,\"y\":0,\"z\":0,\"w\":-0.8}") + "," + Transform("belt"), topic);

            var read = Read(text);

            Assert.That(read.Count, Is.EqualTo(2));
            var box = read[0];
            Assert.That(box.Stamp, Is.EqualTo(ControlTime.FromNanoseconds(12_345_678_900)));
            Assert.That(new[] { box.Parent, box.Child, read[1].Parent, read[1].Child }, Is.EqualTo(new[] { "belt", "box", "world", "belt" }));
            Assert.That(new[] { box.X, box.Y, box.Z, box.Qx, box.Qy, box.Qz, box.Qw }, Is.EqualTo(new[] { 1.5, -2, 0.25, 0.6, 0, 0, -0.8 }).Within(1e-15));
        }

        [Test]
        public void TryRead_Ros1TimeAndOtherFieldOrder_ReturnsTheSameStamp()
        {
            const string Text = "{\"msg\":{\"transforms\":[{\"transform\":{\"rotation\":" + NoRotation + ",\"translation\":" + Origin
                + "},\"child_frame_id\":\"box\",\"header\":{\"seq\":3,\"frame_id\":\"world\",\"stamp\":{\"secs\":12,\"nsecs\":345678900}}}]},"
                + "\"topic\":\"/tf\",\"op\":\"publish\"}";

            Assert.That(Read(Text)[0].Stamp, Is.EqualTo(ControlTime.FromNanoseconds(12_345_678_900)));
        }

        [TestCase(1.0009)]
        [TestCase(0.9991)]
        [TestCase(1.001)]
        [TestCase(0.999)]
        public void TryRead_NormWithinTolerance_IsNormalised(double norm)
        {
            var read = Read(Publish(Transform(rotation: Rotation(0.6 * norm, 0.8 * norm))))[0];

            Assert.That(read.Qx, Is.EqualTo(0.6).Within(1e-15));
            Assert.That(read.Qw, Is.EqualTo(0.8).Within(1e-15));
        }

        [TestCase(1.0011)]
        [TestCase(0.9989)]
        [TestCase(0)]
        [TestCase(1e200)]
        public void TryRead_NormOutsideTolerance_IsRefused(double norm) =>
            Refuse(Publish(Transform(rotation: Rotation(0.6 * norm, 0.8 * norm))), DropReason.NotUnitQuaternion);

        static string Rotation(double x, double w) =>
            "{\"x\":" + x.ToString("R", CultureInfo.InvariantCulture) + ",\"y\":0,\"z\":0,\"w\":" + w.ToString("R", CultureInfo.InvariantCulture) + "}";

        [Test]
        public void TryRead_CoordinateBeyondTheLimit_IsRefused()
        {
            Refuse(Publish(Transform(translation: "{\"x\":0,\"y\":-1.7e308,\"z\":0}")), DropReason.OutOfRange);
            Refuse(Publish(Transform(translation: "{\"x\":1000001,\"y\":0,\"z\":0}")), DropReason.OutOfRange);
        }

        [TestCase("NaN")]
        [TestCase("Infinity")]
        [TestCase("-Infinity")]
        [TestCase("null")]
        [TestCase("1e999")]
        public void TryRead_NumberNotFinite_IsRefused(string number)
        {
            Refuse(Publish(Transform(translation: "{\"x\":0,\"y\":" + number + ",\"z\":0}")), DropReason.NotFinite);
            Refuse(Publish(Transform(rotation: "{\"x\":0,\"y\":0,\"z\":0,\"w\":" + number + "}")), DropReason.NotFinite);
        }

        [TestCase("box", "box", DropReason.OwnParent)]
        [TestCase("", "world", DropReason.MissingField)]
        [TestCase("box", "", DropReason.MissingField)]
        public void TryRead_InvalidNames_AreRefused(string child, string parent, object expected) =>
            Refuse(Publish(Transform(child, parent)), (DropReason)expected);

        [TestCase(128, true)]
        [TestCase(129, false)]
        public void TryRead_NameLength_IsLimitedTo128Characters(int length, bool expected)
        {
            var name = new string('n', length);
            if (expected) Assert.That(Read(Publish(Transform(name))).Count, Is.EqualTo(1));
            else Refuse(Publish(Transform(name)), DropReason.NameTooLong);
            if (!expected) Refuse(Publish(Transform("box", name)), DropReason.NameTooLong);
        }

        [TestCase(32, 128, true)]
        [TestCase(32, 129, false)]
        [TestCase(33, 128, false)]
        public void TryRead_ParentInANamespace_HasTheNameLengthWithoutTheNamespace(int robot, int link, bool expected)
        {
            var text = Publish(Transform("box", new string('r', robot) + "/" + new string('n', link)));
            if (expected) Assert.That(Read(text).Count, Is.EqualTo(1));
            else Refuse(text, DropReason.NameTooLong);
        }

        [Test]
        public void TryRead_DuplicateChild_IsRefused() =>
            Refuse(Publish(Transform("a") + "," + Transform("b") + "," + Transform("a", "b")), DropReason.DuplicateName);

        [TestCase(256, true)]
        [TestCase(257, false)]
        public void TryRead_TransformCount_IsLimitedTo256(int count, bool expected)
        {
            var text = Publish(string.Join(",", Enumerable.Range(0, count).Select(i => Transform("f" + i))));

            if (expected) Assert.That(Read(text).Count, Is.EqualTo(count));
            else Refuse(text, DropReason.TooManyFrames);
        }

        [TestCase("{\"sec\":0,\"nanosec\":0}", DropReason.StampZero)]
        [TestCase("{\"secs\":0,\"nsecs\":0}", DropReason.StampZero)]
        [TestCase("{\"sec\":1,\"nanosec\":1000000000}", DropReason.StampOutOfRange)]
        [TestCase("{\"sec\":-1,\"nanosec\":0}", DropReason.StampOutOfRange)]
        [TestCase("{}", DropReason.MissingField)]
        [TestCase("null", DropReason.WrongType)]
        public void TryRead_InvalidStamp_ReturnsTheReason(string stamp, object expected) =>
            Refuse(Publish(Transform(stamp: stamp)), (DropReason)expected);

        [TestCase("{\"sec\":0,\"nanosec\":0}")]
        [TestCase("{\"secs\":0,\"nsecs\":0}")]
        public void TryRead_StationaryFrameWithoutStamp_IsRead(string stamp) =>
            Assert.That(Read(Publish(Transform(stamp: stamp), "/tf_static"))[0].Stamp, Is.EqualTo(default(ControlTime)));

        [TestCase("{}", DropReason.MissingField)]
        [TestCase("{\"transforms\":[]}", DropReason.MissingField)]
        [TestCase("{\"transforms\":{}}", DropReason.WrongType)]
        [TestCase("{\"transforms\":[1]}", DropReason.WrongType)]
        [TestCase("{\"transforms\":[{}]}", DropReason.MissingField)]
        [TestCase("{\"transforms\":[],\"transforms\":[]}", DropReason.DuplicateField)]
        public void TryRead_InvalidBody_IsRefused(string body, object expected) =>
            Refuse("{\"op\":\"publish\",\"topic\":\"/tf\",\"msg\":" + body + "}", (DropReason)expected);

        [TestCase("\"x\":0,\"y\":0", DropReason.MissingField)]
        [TestCase("\"x\":0,\"y\":0,\"z\":0,\"z\":0", DropReason.DuplicateField)]
        [TestCase("\"x\":0,\"y\":0,\"z\":\"0\"", DropReason.WrongType)]
        public void TryRead_InvalidTranslation_IsRefused(string fields, object expected) =>
            Refuse(Publish(Transform(translation: "{" + fields + "}")), (DropReason)expected);

        [TestCase(0, true)]
        [TestCase(1, false)]
        public void TryRead_MessageSize_IsLimitedTo64KiB(int over, bool expected)
        {
            var text = Publish(Transform());
            text = new string(' ', 64 * 1024 + over - text.Length) + text;

            if (expected) Read(text);
            else Refuse(text, DropReason.TooLarge);
        }

        [TestCase(RosTimeForm.Sec)]
        [TestCase(RosTimeForm.Secs)]
        public void PublishTransforms_ReadBack_RoundTrips(object form)
        {
            var sent = new TransformsMessage(
                new FrameTransform(ControlTime.FromNanoseconds(12_345_678_900), "world", "a\"\\é", 1.0 / 3, -2e-9, 1e5, 0, 0.6, 0, 0.8),
                new FrameTransform(ControlTime.FromSeconds(3), "arm1/tool0", "b", 0, 0, 0, 0, 0, 0, -1));

            var text = RosbridgeWriter.Publish("/tf", sent, (RosTimeForm)form);

            Assert.That(text.Contains("\"secs\":"), Is.EqualTo((RosTimeForm)form == RosTimeForm.Secs));
            var read = Read(text);
            Assert.That(read.Count, Is.EqualTo(2));
            for (var i = 0; i < 2; i++)
            {
                Assert.That(read[i].Stamp, Is.EqualTo(sent[i].Stamp));
                Assert.That(read[i].Parent, Is.EqualTo(sent[i].Parent));
                Assert.That(read[i].Child, Is.EqualTo(sent[i].Child));
                Assert.That(Numbers(read[i]), Is.EqualTo(Numbers(sent[i])));
            }
        }

        static double[] Numbers(FrameTransform one) => new[] { one.X, one.Y, one.Z, one.Qx, one.Qy, one.Qz, one.Qw };

        [Test]
        public void TryRead_MessageReleased_IsReusedWithoutPreviousValues()
        {
            var reader = new RosbridgeReader();
            var first = ReadWith(reader, Publish(Transform("a") + "," + Transform("b")));
            var name = first[1].Child;
            first.Release();

            var second = ReadWith(reader, Publish(Transform("b")));

            Assert.That(second, Is.SameAs(first));
            Assert.That(second.Count, Is.EqualTo(1));
            Assert.That(second[0].Child, Is.SameAs(name));
        }

        [Test]
        public void TryRead_MessageNotReleased_IsUnchanged()
        {
            var reader = new RosbridgeReader();
            var first = ReadWith(reader, Publish(Transform("a")));

            ReadWith(reader, Publish(Transform("b")));

            Assert.That(first[0].Child, Is.EqualTo("a"));
        }

        [Test]
        public void TryRead_MoreNamesThanTheCacheHolds_AreAllRead()
        {
            var reader = new RosbridgeReader();
            for (var round = 0; round < 2; round++)
            {
                for (var i = 0; i < 3000; i++)
                {
                    var read = ReadWith(reader, Publish(Transform("f" + i)));
                    Assert.That(read[0].Child, Is.EqualTo("f" + i));
                    read.Release();
                }
            }
        }

        static TransformsMessage ReadWith(RosbridgeReader reader, string text)
        {
            Assert.That(reader.TryRead(Encoding.UTF8.GetBytes(text), out var message, out var reason), Is.True, reason.ToString());
            return message.Transforms;
        }
    }
}
