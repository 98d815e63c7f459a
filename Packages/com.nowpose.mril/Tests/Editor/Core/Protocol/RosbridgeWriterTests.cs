using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Tests.Core.Protocol
{
    public class RosbridgeWriterTests
    {
        const int Seed = 7;

        static RosbridgeMessage Read(string text)
        {
            Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, reason + ": " + text);
            return message;
        }

        [TestCase(RosTimeForm.Sec)]
        [TestCase(RosTimeForm.Secs)]
        public void JointState_ReadBack_RoundTrips(object form)
        {
            var random = new Random(Seed);
            for (var i = 0; i < 300; i++)
            {
                var state = RandomState(random);

                var read = Read(RosbridgeWriter.Publish("/joint_states", state, (RosTimeForm)form)).JointState;

                Assert.That(read.Stamp, Is.EqualTo(state.Stamp), "message " + i + ", seed " + Seed);
                Assert.That(read.Names, Is.EqualTo(state.Names));
                Assert.That(read.Positions, Is.EqualTo(state.Positions));
                Assert.That(read.Velocities, Is.EqualTo(state.Velocities));
            }
        }

        [Test]
        public void JointState_Ros1AndRos2_HaveDifferentStampFields()
        {
            var state = new JointStateMessage(ControlTime.FromNanoseconds(1_000_000_200), Array.Empty<string>(), Array.Empty<double>());

            Assert.That(RosbridgeWriter.Publish("/joint_states", state, RosTimeForm.Secs), Does.Contain("{\"secs\":1,\"nsecs\":200}"));
            Assert.That(RosbridgeWriter.Publish("/joint_states", state, RosTimeForm.Sec), Does.Contain("{\"sec\":1,\"nanosec\":200}"));
        }

        [Test]
        public void JointState_CultureWithDecimalComma_WritesDecimalPoints()
        {
            using var culture = new DecimalComma();
            var state = new JointStateMessage(ControlTime.FromSeconds(1), new[] { "a" }, new[] { -1.5 });

            Assert.That(RosbridgeWriter.Publish("/joint_states", state, RosTimeForm.Sec), Does.Contain("[-1.5]"));
        }

        [TestCase(double.NaN)]
        [TestCase(double.PositiveInfinity)]
        [TestCase(double.NegativeInfinity)]
        public void JointState_PositionNotFinite_IsRefused(double position)
        {
            var state = new JointStateMessage(ControlTime.FromSeconds(1), new[] { "a" }, new[] { position });

            Assert.Throws<ArgumentException>(() => RosbridgeWriter.Publish("/joint_states", state, RosTimeForm.Sec));
        }

        [Test]
        public void JointTrajectory_ReadBack_RoundTrips()
        {
            var points = new[]
            {
                new JointTrajectoryPoint(TimeSpan.Zero, new[] { 1.0, 2 }, new[] { 0.5, double.NaN }, new[] { double.NaN, -3 }),
                new JointTrajectoryPoint(Lengths.Seconds(1.25), new[] { 3.0, 4 }),
            };
            var sent = new JointTrajectoryMessage(ControlTime.FromSeconds(9), new[] { "a", "b" }, points);

            var read = Read(RosbridgeWriter.Publish("/joint_trajectory", sent, RosTimeForm.Secs)).JointTrajectory;

            Assert.That(read.Stamp, Is.EqualTo(sent.Stamp));
            Assert.That(read.Names, Is.EqualTo(sent.Names));
            Assert.That(read.Points.Select(point => point.TimeFromStart), Is.EqualTo(points.Select(point => point.TimeFromStart)));
            Assert.That(read.Points.SelectMany(point => point.Positions), Is.EqualTo(new[] { 1.0, 2, 3, 4 }));
            Assert.That(read.Points[0].Velocities, Is.EqualTo(new[] { 0.5, double.NaN }));
            Assert.That(read.Points[0].Accelerations, Is.EqualTo(new[] { double.NaN, -3 }));
            Assert.That(read.Points[1].Velocities, Is.Null);
            Assert.That(read.Points[1].Accelerations, Is.Null);
        }

        [Test]
        public void JointTrajectory_PositionsOnly_HasNoEmptyArrays()
        {
            var points = new[] { new JointTrajectoryPoint(TimeSpan.Zero, new[] { 1.0 }) };

            var text = RosbridgeWriter.Publish(
                "/joint_trajectory", new JointTrajectoryMessage(ControlTime.FromSeconds(9), new[] { "a" }, points), RosTimeForm.Sec);

            Assert.That(text, Does.Not.Contain("[]"));
        }

        [Test]
        public void Subscribe_ReadBack_RoundTrips()
        {
            var message = Read(RosbridgeWriter.Subscribe("/joint_states", "sensor_msgs/JointState"));

            Assert.That(message.Op, Is.EqualTo(RosbridgeOp.Subscribe));
            Assert.That(message.Topic, Is.EqualTo("/joint_states"));
            Assert.That(message.Type, Is.EqualTo("sensor_msgs/JointState"));
        }

        [Test]
        public void Advertise_ReadBack_ReturnsTheOperation() =>
            Assert.That(Read(RosbridgeWriter.Advertise("/a", "t/T", "1")).Op, Is.EqualTo(RosbridgeOp.Advertise));

        [Test]
        public void Description_ReadBack_RoundTrips()
        {
            const string Urdf = "<robot name=\"ü\">\n\t\"quoted\" \\ \u0001 </robot>";

            Assert.That(Read(RosbridgeWriter.Publish("/robot_description", new StringMessage(Urdf))).Data, Is.EqualTo(Urdf));
        }

        [Test]
        public void Diagnostics_ReadBack_RoundTrips()
        {
            var values = new[] { Pair("state", "synchronised"), Pair("rtt_ms", "3.5") };
            var sent = new DiagnosticsMessage(default, "headset 1", values, 2, "plant/cell", "a fault: gone");

            var read = Read(RosbridgeWriter.Publish("/nowpose/diagnostics", sent, RosTimeForm.Sec)).Diagnostics;

            Assert.That(read.HardwareId, Is.EqualTo("headset 1"));
            Assert.That(read.Values, Is.EqualTo(values));
            Assert.That(read.Stamp, Is.EqualTo(default(ControlTime)));
            Assert.That(read.Level, Is.EqualTo(2));
            Assert.That(read.Name, Is.EqualTo("plant/cell"));
            Assert.That(read.Message, Is.EqualTo("a fault: gone"));
        }

        [TestCase(256, true)]
        [TestCase(257, false)]
        public void Diagnostics_KeyWithPrefixAndNamespace_MayBeLongerThanAName(int length, bool expected)
        {
            var key = "reduction_uncertainty/".PadRight(length, 'n');
            var text = RosbridgeWriter.Publish(
                "/nowpose/diagnostics", new DiagnosticsMessage(default, "headset 1", new[] { Pair(key, "0.1") }), RosTimeForm.Sec);

            Assert.That(RosbridgeReader.TryRead(text, out _, out var reason), Is.EqualTo(expected));
            Assert.That(reason, Is.EqualTo(expected ? DropReason.None : DropReason.NameTooLong));
        }

        [TestCase("", 0)]
        [TestCase("\"level\":1,", 1)]
        [TestCase("\"level\":255,", 3)]
        [TestCase("\"level\":-1,", 0)]
        [TestCase("\"level\":\"AA==\",\"name\":null,\"message\":7,", 0)]
        public void Diagnostics_Level_IsClampedAndDefaultsToZero(string level, int expected)
        {
            var text = "{\"op\":\"publish\",\"topic\":\"/nowpose/diagnostics\",\"msg\":{\"status\":[{" + level + "\"hardware_id\":\"h\",\"values\":[]}]}}";

            var read = Read(text).Diagnostics;

            Assert.That(read.Level, Is.EqualTo(expected));
            Assert.That(read.Name + read.Message, Is.Empty);
        }

        [Test]
        public void Service_CallAndResponse_ContainIdAndTime()
        {
            var call = Read(RosbridgeWriter.CallService("/rosapi/get_time", "c7"));
            var time = ControlTime.FromNanoseconds(1_700_000_000_123_456_700);

            var response = Read(RosbridgeWriter.TimeResponse(call.Service, call.Id, time, RosTimeForm.Secs));

            Assert.That(response.Id.Text, Is.EqualTo("c7"));
            Assert.That(response.Result, Is.True);
            Assert.That(response.Time, Is.EqualTo(time));
        }

        [Test]
        public void FailedResponse_ReadBack_ResultIsFalse()
        {
            var response = Read(RosbridgeWriter.FailedResponse("/a", "1", "no such service"));

            Assert.That(response.Result, Is.False);
        }

        [Test]
        public void Status_ReadBack_RoundTrips()
        {
            var message = Read(RosbridgeWriter.Status("error", "Unknown operation: dance", "4"));

            Assert.That(message.Level, Is.EqualTo("error"));
            Assert.That(message.Text, Is.EqualTo("Unknown operation: dance"));
            Assert.That(message.Id.Text, Is.EqualTo("4"));
        }

        static KeyValuePair<string, string> Pair(string key, string value) => new KeyValuePair<string, string>(key, value);

        static JointStateMessage RandomState(Random random)
        {
            var count = random.Next(1, 9);
            var names = Enumerable.Range(0, count).Select(i => "joint \"" + i + "\" \u00e9").ToArray();
            var positions = names.Select(_ => Number(random)).ToArray();
            var velocities = names.Select(_ => random.Next(4) == 0 ? double.NaN : Number(random)).ToArray();
            var stamp = ControlTime.FromNanoseconds(100L * random.Next(1, int.MaxValue) * random.Next(1, 1_000_000));
            return new JointStateMessage(stamp, names, positions, random.Next(2) == 0 ? null : velocities);
        }

        static double Number(Random random) => (random.NextDouble() - 0.5) * Math.Pow(10, random.Next(-12, 13));
    }
}
