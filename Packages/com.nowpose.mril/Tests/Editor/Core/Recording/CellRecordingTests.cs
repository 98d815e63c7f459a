using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Tests.Core.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Recording.RecordableSession;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>Tests the recorded lines of frames, signals and other robots.</summary>
    public class CellRecordingTests
    {
        [Test]
        public void Pose_ReceivedFrames_HaveTheirParentsAndStamps()
        {
            var session = NewSession();
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                Synchronise(session);
                var stamp = new ControlTime((Start + Lengths.Ms(900)).SinceEpoch);
                session.Frames.Add(new TransformsMessage(new FrameTransform(default, "world", "table", 1, 2, 3, 0, 0, 0, 1)), true, Start + Lengths.Ms(910));
                session.Frames.Add(new TransformsMessage(new FrameTransform(stamp, "table", "part", 0.1, 0.2, 1 / 3.0, 0, 0.6, 0, 0.8)), false, Start + Lengths.Ms(950));
                session.Frames.Add(new TransformsMessage(new FrameTransform(stamp, "table", "part", 0.1, 0.2, 0.3, 0, 0.6, 0, 0.8)), false, Start + Lengths.Ms(960));
                session.Tick(Start + Lengths.Ms(1000));
                run.Flush();
            }

            var poses = run.Of("pose").ToList();
            Assert.That(poses.Select(pose => (string)pose["frame"]), Is.EqualTo(new[] { "table", "part", "part" }));
            Assert.That(poses.Select(pose => (string)pose["parent"]), Is.EqualTo(new[] { "world", "table", "table" }));
            Assert.That(poses.Select(pose => (bool?)pose["stationary"]), Is.EqualTo(new bool?[] { true, null, null }));
            Assert.That((long)poses[1]["stamp_ns"], Is.EqualTo(100_900_000_000));
            Assert.That((long)poses[1]["arrival_ns"], Is.EqualTo(100_950_000_000));
            Assert.That(poses[1]["position"].Select(number => (double)number), Is.EqualTo(new[] { 0.1, 0.2, 1 / 3.0 }));
            Assert.That(poses[1]["rotation"].Select(number => (double)number), Is.EqualTo(new[] { 0, 0.6, 0, 0.8 }));
            Assert.That(poses.Select(pose => (string)pose["dropped"]), Is.EqualTo(new[] { null, null, "late_sample" }));
        }

        [Test]
        public void Object_ShownMovingFrame_HasItsDisplayedPoseInEachFrame()
        {
            var session = NewSession();
            foreach (var name in new[] { "table", "part" }) session.Frames.Need(name);
            var shown = new List<(long Start, long? Light, string State, double X, double Y)>();
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                Synchronise(session);
                session.Frames.Add(new TransformsMessage(new FrameTransform(default, "world", "table", 0, 2, 0, 0, 0, 0, 1)), true, Start);
                for (var ms = 900; ms < 3000; ms += 50)
                {
                    var (now, stamp) = (Start + Lengths.Ms(ms), new ControlTime((Start + Lengths.Ms(ms - 40)).SinceEpoch));
                    FrameTransform Pose(string child) => new FrameTransform(stamp, "table", child, (ms - 40) / 1000.0, 0, 0, 0, 0.6, 0, 0.8);
                    session.Clock.Add(Exchange(now), out _);
                    // The poses stop after a second.
                    if (ms < 1900) session.Frames.Add(new TransformsMessage(Pose("part"), Pose("not shown")), false, now);
                    var frame = session.Tick(now);
                    var part = session.Frames.Find("part");
                    shown.Add((now.Nanoseconds, frame.DisplayTime?.Nanoseconds, session.Frames.StateOf(part).ToString().ToLowerInvariant(), part.World.X, part.World.Y));
                }
                run.Flush();
            }

            var lines = run.Of("object");
            Assert.That(lines.Select(line => (string)line["frame"]).Distinct(), Is.EqualTo(new[] { "part" }));
            Assert.That(
                lines.Select(line => ((long)line["start_ns"], (long?)line["light_ns"], (string)line["state"], (double)line["position"][0], (double)line["position"][1])),
                Is.EqualTo(shown));
            Assert.That(shown.Select(one => one.State), Has.Some.EqualTo("current").And.Some.EqualTo("held"));
            Assert.That(shown[15].X, Is.EqualTo(0.9 + 15 * 0.05 + 0.04).Within(2e-3), "predicted to the display time");
            Assert.That(shown[15].Y, Is.EqualTo(2));
            Assert.That(lines[15]["rotation"].Select(number => (double)number), Is.EqualTo(new[] { 0, 0.6, 0, 0.8 }).Within(1e-9));
        }

        [Test]
        public void Signal_ReceivedValues_HaveTheirStamps()
        {
            var session = NewSession();
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                Synchronise(session);
                var stamp = new ControlTime((Start + Lengths.Ms(900)).SinceEpoch);
                session.Signals.Add(new SignalsMessage(stamp, new SignalValue("closed", 1), new SignalValue("speed", 0.25)), Start + Lengths.Ms(950));
                session.Signals.Add(new SignalsMessage(stamp + Lengths.Ms(5000), new SignalValue("closed", 0)), Start + Lengths.Ms(960));
                session.Tick(Start + Lengths.Ms(1000));
                run.Flush();
            }

            Assert.That(run.Of("signal").Select(line => ((string)line["name"], (double)line["value"], (long)line["stamp_ns"], (string)line["dropped"])), Is.EqualTo(new[]
            {
                ("closed", 1.0, 100_900_000_000, null), ("speed", 0.25, 100_900_000_000, null), ("closed", 0.0, 105_900_000_000, "stamp_in_future"),
            }));
        }

        [Test]
        public void Recorder_StartsDuringTheSession_ContainsStationaryPosesAndSignals()
        {
            var session = NewSession();
            Synchronise(session);
            session.Signals.Need();
            session.Frames.Need("table");
            var stamp = new ControlTime((Start + Lengths.Ms(900)).SinceEpoch);
            FrameTransform Pose(string child, double x) => new FrameTransform(stamp, "world", child, x, 2, 3, 0, 0, 0, 1);
            session.Frames.Add(new TransformsMessage(Pose("table", 1), Pose("rail", 4), Pose("shuttle", 5)), true, Start + Lengths.Ms(910));
            session.Frames.Add(new TransformsMessage(Pose("shuttle", 6)), false, Start + Lengths.Ms(920));
            session.Signals.Add(new SignalsMessage(stamp, new SignalValue("closed", 1)), Start + Lengths.Ms(930));
            session.Signals.Add(new SignalsMessage(stamp + Lengths.Ms(300), new SignalValue("closed", 0)), Start + Lengths.Ms(940));
            session.Tick(Start + Lengths.Ms(1000));

            RecordedRun run;
            using (run = new RecordedRun(session)) run.Flush();

            Assert.That(
                run.Of("pose").Select(pose => ((string)pose["frame"], (double)pose["position"][0], (long)pose["stamp_ns"], (long)pose["arrival_ns"], (bool?)pose["stationary"])),
                Is.EquivalentTo(new (string, double, long, long, bool?)[]
                {
                    ("table", 1, 100_900_000_000, 100_910_000_000, true), ("rail", 4, 100_900_000_000, 100_910_000_000, true),
                }));
            Assert.That(
                run.Of("signal").Select(line => ((string)line["name"], (double)line["value"], (long)line["stamp_ns"], (string)line["dropped"])),
                Is.EqualTo(new[] { ("closed", 1.0, 100_900_000_000, null), ("closed", 0.0, 101_200_000_000, (string)null) }));
        }

        [Test]
        public void Pose_FramePlacedByHand_IsRecordedAtThePlacementAndAtALaterStart([Values] bool isPlacedBefore)
        {
            var session = NewSession();
            Synchronise(session);
            session.Frames.Need("fixture");
            session.Tick(Start + Lengths.Ms(1000));
            if (isPlacedBefore) session.Frames.Place("fixture", RigidTransform.FromXyzRpy(1, 2, 3, 0, 0, 0));
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                if (!isPlacedBefore) session.Frames.Place("fixture", RigidTransform.FromXyzRpy(1, 2, 3, 0, 0, 0));
                session.Tick(Start + Lengths.Ms(1100));
                run.Flush();
            }

            var pose = run.Of("pose").Single();
            Assert.That(((string)pose["frame"], (string)pose["parent"], (bool?)pose["stationary"]), Is.EqualTo(("fixture", "world", (bool?)true)));
            Assert.That(pose["position"].Select(number => (double)number), Is.EqualTo(new[] { 1.0, 2, 3 }));
            Assert.That((long)pose["arrival_ns"], Is.EqualTo(101_000_000_000), "the frame that was displayed then");
            Assert.That(session.Drops.Total, Is.Zero);
        }

        [Test]
        public void Object_StationaryFrame_HasItsStateWhileItIsNotCurrent()
        {
            var session = NewSession();
            session.Frames.Need("table");
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                Synchronise(session);
                session.Listener.Connected(Start);
                session.Frames.Add(new TransformsMessage(new FrameTransform(default, "world", "table", 0, 2, 0, 0, 0, 0, 1)), true, Start);
                session.Tick(Start + Lengths.Ms(1000));
                session.Listener.Connected(Start + Lengths.Ms(1500));
                for (var ms = 1500; ms <= 5000; ms += 500)
                {
                    session.Clock.Add(Exchange(Start + Lengths.Ms(ms)), out _);
                    session.Tick(Start + Lengths.Ms(ms));
                }
                run.Flush();
            }

            Assert.That(
                run.Of("object").Select(line => ((string)line["frame"], (string)line["state"], (long)line["start_ns"])),
                Is.EqualTo(new[] { 4000, 4500, 5000 }.Select(ms => ("table", "held", 100_000_000_000 + ms * 1_000_000L))));
        }

        [Test]
        public void Sample_FirstOfARobotAddedDuringTheRecording_IsRecordedAfterTheDescription()
        {
            var session = NewSession();
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                Synchronise(session);
                var names = new[] { "shoulder", "elbow" };
                session.Robots.Add("arm2", TestRobot.Model).Intake.Add(
                    new JointStateMessage(new ControlTime((Start + Lengths.Ms(900)).SinceEpoch), names, new double[2]), Start + Lengths.Ms(950));
                session.Tick(Start + Lengths.Ms(1000));
                run.Flush();
            }

            var kinds = run.Lines.Select(line => (string)line["kind"]).Where(kind => kind == "robot" || kind == "sample");
            Assert.That(kinds, Is.EqualTo(new[] { "robot", "sample" }));
        }

        [TestCase("", "arm2")]
        [TestCase("arm1", "")]
        public void Sample_OtherRobot_HasItsNamespaceBeforeTheJointNames(string main, string name)
        {
            var run = RunWithAnotherRobot(main, name);

            Assert.That((string)run.Of("robot").Single()["namespace"], Is.EqualTo(name));
            Assert.That(run.Of("sample").Select(line => (string)line["names"][0]), Is.EquivalentTo(
                new[] { name + "/" + TestRobot.Model.MovingJoints[0].Name, TestRobot.Model.MovingJoints[0].Name }));
        }

        [Test]
        public void Robot_AddedDuringTheRecording_IsDescribedBeforeItsSamples()
        {
            var run = RunWithAnotherRobot();

            var robot = run.Of("robot").Single();
            Assert.That((string)robot["namespace"], Is.EqualTo("arm2"));
            Assert.That(robot["joints"].ToString(), Is.EqualTo(run.Lines[0]["robot"]["joints"].ToString()));
            var kinds = run.Lines.Select(line => (string)line["kind"]).ToList();
            Assert.That(kinds.IndexOf("sample"), Is.GreaterThan(kinds.IndexOf("robot")));
        }

        static RecordedRun RunWithAnotherRobot(string main = "", string name = "arm2")
        {
            var session = NewSession(main);
            using var run = new RecordedRun(session);
            Synchronise(session);
            var other = session.Robots.Add(name, TestRobot.Model);
            session.Tick(Start + Lengths.Ms(1000));
            var names = TestRobot.Model.MovingJoints.Select(joint => joint.Name).ToArray();
            var message = new JointStateMessage(new ControlTime((Start + Lengths.Ms(1000)).SinceEpoch), names, new double[names.Length]);
            other.Intake.Add(message, Start + Lengths.Ms(1050));
            session.Intake.Add(message, Start + Lengths.Ms(1060));
            session.Tick(Start + Lengths.Ms(1100));
            run.Flush();
            return run;
        }
    }
}
