using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Mono.Aot
{
    /// <summary>Writes each kind of message and reads it back.</summary>
    static class Messages
    {
        static readonly ControlTime Stamp = ControlTime.FromNanoseconds(12_345_678_900);
        static readonly string[] Names = { "a", "b" };
        static readonly double[] Positions = { 1.5, -2 };

        public static void Check()
        {
            foreach (var form in new[] { RosTimeForm.Sec, RosTimeForm.Secs })
            {
                var state = Read(RosbridgeWriter.Publish(
                    RosTopics.JointStates, new JointStateMessage(Stamp, Names, Positions), form)).JointState;
                Program.Require(state.Stamp == Stamp && state.Positions.SequenceEqual(Positions), "joint state");

                var points = new[] { new JointTrajectoryPoint(TimeSpan.FromSeconds(2), Positions) };
                var plan = Read(RosbridgeWriter.Publish(
                    RosTopics.JointTrajectory, new JointTrajectoryMessage(Stamp, Names, points), form)).JointTrajectory;
                Program.Require(plan.Points.Count == 1 && plan.Points[0].TimeFromStart == TimeSpan.FromSeconds(2), "joint trajectory");

                var values = new[] { new KeyValuePair<string, string>("key", "value") };
                var diagnostics = Read(RosbridgeWriter.Publish(
                    RosTopics.Diagnostics, new DiagnosticsMessage(Stamp, "headset", values), form)).Diagnostics;
                Program.Require(diagnostics.Values.Count == 1 && diagnostics.Values[0].Value == "value", "diagnostics");

                var box = new FrameTransform(Stamp, "world", "box", 1.5, 0, -2, 0, 0, 0.6, 0.8);
                var transforms = Read(RosbridgeWriter.Publish(RosTopics.Tf, new TransformsMessage(box), form)).Transforms;
                Program.Require(transforms.Count == 1 && transforms[0].Child == "box" && transforms[0].Stamp == Stamp, "transforms");

                var signals = Read(RosbridgeWriter.Publish(
                    RosTopics.Signals, new SignalsMessage(Stamp, new SignalValue("grip", 1)), form)).Signals;
                Program.Require(signals.Count == 1 && signals[0].Value == 1 && signals.Stamp == Stamp, "signals");

                Program.Require(Read(RosbridgeWriter.TimeResponse(RosTopics.GetTime, "1", Stamp, form)).Time == Stamp, "time response");
            }
            var description = Read(RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage("<robot/>"))).Data;
            Program.Require(description == "<robot/>", "robot description");
            Program.Require(Read(RosbridgeWriter.Subscribe(RosTopics.JointStates)).Topic == RosTopics.JointStates, "subscribe");
            Program.Require(Read(RosbridgeWriter.Status("error", "text")).Text == "text", "status");
            Program.Require(!RosbridgeReader.TryRead("{\"op\":", out _, out var reason) && reason == DropReason.NotJson, "bad JSON");

            var bytes = new byte[SyncFrame.Size];
            var request = SyncFrame.Request(7, 123_456_789);
            request.Write(bytes);
            Program.Require(SyncFrame.TryRead(bytes, out var frame, out _) && frame.Equals(request), "clock sync request");
        }

        static RosbridgeMessage Read(string text)
        {
            Program.Require(RosbridgeReader.TryRead(text, out var message, out var reason), reason + ": " + text);
            return message;
        }
    }
}
