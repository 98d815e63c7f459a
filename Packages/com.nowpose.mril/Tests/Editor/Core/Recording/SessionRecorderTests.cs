using System;
using System.Collections.Generic;
using System.Linq;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Tests.Core.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Recording.RecordableSession;

namespace Nowpose.Tests.Core.Recording
{
    /// <summary>Tests the lines that a recording contains.</summary>
    public class SessionRecorderTests
    {
        [Test]
        public void Header_Session_HasTheSettingsWithoutSecrets()
        {
            RecordedRun run;
            using (run = new RecordedRun(NewSession())) run.Flush();

            var header = run.Lines[0];
            Assert.That((string)header["kind"], Is.EqualTo("session"));
            Assert.That((string)header["format"], Is.EqualTo("nowpose-session"));
            Assert.That((int)header["version"], Is.EqualTo(1));
            Assert.That((string)header["headset"], Is.EqualTo("test \"one\"\n"));
            Assert.That((string)header["started_utc"], Is.EqualTo("2026-01-02T03:04:05Z"));
            Assert.That((string)header["robot"]["description_sha256"], Is.EqualTo(TestRobot.Model.SourceHash).And.Length.EqualTo(64));
            Assert.That(header["robot"]["joints"].Select(j => (string)j["name"]), Is.EqualTo(TestRobot.Model.MovingJoints.Select(j => j.Name)));
            Assert.That(header["robot"]["joints"].Select(j => (string)j["unit"]), Is.EqualTo(new[] { "rad", "rad", "m", "m" }));
            Assert.That((double)header["robot"]["joints"][0]["upper"], Is.EqualTo(3));
            Assert.That(header["robot"]["joints"][1]["upper"], Is.Null, "a continuous joint has no limit");
            Assert.That((double)header["settings"]["visualisation_ms"], Is.EqualTo(40));
            Assert.That((string)header["settings"]["render_time_source"], Is.EqualTo("gpu_completion"));
            Assert.That(run.Text, Does.Not.Contain("secret"));
        }

        // With RewriteBeforeRender, the first computation of a frame is not displayed.
        [Test]
        public void Frame_ComputedTwice_HasOneLineWithTheDisplayedPoses()
        {
            var session = NewSession();
            session.Frames.Need("part");
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                Synchronise(session);
                session.Frames.Add(
                    new TransformsMessage(new FrameTransform(new ControlTime((Start + Lengths.Ms(900)).SinceEpoch), "world", "part", 1, 0, 0, 0, 0, 0, 1)), false,
                    Start + Lengths.Ms(950));
                session.Tick(Start + Lengths.Ms(1000), isLast: false);
                session.Tick(Start + Lengths.Ms(1008));
                run.Flush();
            }

            foreach (var kind in new[] { "frame", "object" })
                Assert.That(run.Of(kind).Select(line => (long)line["start_ns"]), Is.EqualTo(new[] { 101_008_000_000 }), kind);
        }

        [Test]
        public void Header_SomeConditionsUnknown_ContainsOnlyTheKnownConditions()
        {
            var session = NewSession();
            session.Conditions = new DisplayConditions("HoloLens 2", 59.94, graphicsApi: "Direct3D11");
            session.Reprojection = ReprojectionMode.PlanarFromDepth;

            RecordedRun run;
            using (run = new RecordedRun(session)) run.Flush();

            Assert.That(run.Lines[0]["conditions"].ToString(Formatting.None), Is.EqualTo(
                "{\"device\":\"HoloLens 2\",\"display_hz\":59.94,\"graphics_api\":\"Direct3D11\",\"rewrite_before_render\":\"off\","
                + "\"reprojection\":\"planar_from_depth\"}"));
        }

        [Test]
        public void Display_ReprojectionReportedAfterTheStart_WritesAnotherLine()
        {
            var session = NewSession();
            RecordedRun run;
            using (run = new RecordedRun(session))
            {
                session.Tick(Start);
                session.Reprojection = ReprojectionMode.Depth;
                session.Tick(Start + Lengths.Ms(16));
                session.Tick(Start + Lengths.Ms(33));
            }

            Assert.That(run.Of("display").Select(line => (string)line["reprojection"]), Is.EqualTo(new[] { null, "depth" }));
        }

        // Also with a culture that writes other numbers.
        [Test]
        public void Lines_SimulatedSession_ContainItsEventsInOrder()
        {
            using var culture = new DecimalComma();
            var simulated = new SimulatedSession(NetworkProfile.Wifi, seed: 7);
            var taken = new List<Arrival<JointStateMessage>>();
            var exchanges = new List<SyncExchange>();
            var frames = new List<(long Start, long? Light, double[] Joints, double[] Held)>();
            simulated.Session.Intake.SampleTaken += (arrival, _) => taken.Add(arrival);
            simulated.Session.Clock.Judged += (in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault) => exchanges.Add(exchange);
            var run = new RecordedRun(simulated.Session);

            for (var second = 0; second < 20; second++)
            {
                simulated.Run(1, (frame, _) => frames.Add(
                    (frame.Start.Nanoseconds, frame.DisplayTime?.Nanoseconds, frame.Joints.ToArray(), frame.HeldJoints.ToArray())));
                run.Flush();
            }
            run.Close();

            Assert.That(run.Recorder.LostLines, Is.EqualTo(0));
            Assert.That(taken, Has.Count.GreaterThan(350));
            var samples = run.Of("sample").Where(s => s["dropped"] == null).ToList();
            Assert.That(samples.Select(s => (long)s["stamp_ns"]), Is.EqualTo(taken.Select(a => a.Message.Stamp.Nanoseconds)));
            Assert.That(samples.Select(s => (long)s["arrival_ns"]), Is.EqualTo(taken.Select(a => a.At.Nanoseconds)));
            Assert.That(
                samples.SelectMany(s => s["position"].Select(p => (double)p)), Is.EqualTo(taken.SelectMany(a => a.Message.Positions)),
                "all digits are written");
            Assert.That(run.Of("sync").Select(s => (long)s["t1_ns"]), Is.EqualTo(exchanges.Select(e => e.T1.Nanoseconds)));
            Assert.That(run.Of("sync").Select(s => (long)s["t3_ns"]), Is.EqualTo(exchanges.Select(e => e.T3.Nanoseconds)));
            var lines = run.Of("frame");
            Assert.That(lines.Select(f => (long)f["start_ns"]), Is.EqualTo(frames.Select(f => f.Start)));
            Assert.That(lines.Select(f => (long?)f["light_ns"]), Is.EqualTo(frames.Select(f => f.Light)));
            Assert.That(lines.SelectMany(f => f["joints"].Select(p => (double)p)), Is.EqualTo(frames.SelectMany(f => f.Joints)));
            Assert.That(lines.SelectMany(f => f["held"].Select(p => (double)p)), Is.EqualTo(frames.SelectMany(f => f.Held)));
            Assert.That(run.Of("clock").Select(c => (string)c["state"]).Last(), Is.EqualTo("synchronised"));
            Assert.That(run.Of("statistics"), Has.Count.EqualTo(20));
            var last = run.Of("statistics")[19];
            Assert.That((double)last["tool_mm"]["reduction"], Is.GreaterThan(0.5));
            Assert.That((double)last["tool_mm"]["hold_p95"], Is.GreaterThan((double)last["tool_mm"]["p95"]));
            Assert.That((int)last["tool_of_run_mm"]["frames"], Is.GreaterThan((int)last["tool_mm"]["frames"]));
            Assert.That(last["joint_errors"].Select(j => (string)j["joint"]), Is.EqualTo(new[] { "shoulder", "elbow" }));
            Assert.That((double)last["joint_errors"][1]["rms"], Is.GreaterThan(0));
            Assert.That((string)run.Last["reason"], Is.EqualTo("closed"));
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Statistics_RenderTimesMissing_ReasonReplacesTheErrorOnlyWithALimit(bool hasLimit)
        {
            var simulated = new SimulatedSession(
                NetworkProfile.Lan, seed: 7, range: hasLimit ? new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime) : null);
            var run = new RecordedRun(simulated.Session);

            simulated.Run(5);
            run.Close();

            var last = run.Of("statistics").Last();
            Assert.That((string)last["error_withheld"], Is.EqualTo(hasLimit ? StateNames.RenderTimeNotMeasured : null));
            Assert.That((last["tool_mm"] == null, last["tool_of_run_mm"] == null), Is.EqualTo((hasLimit, hasLimit)));
        }

        [Test]
        public void Frame_EstimatedError_EqualsThatOfTheClock()
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, seed: 7);
            var expected = new List<long?>();
            var run = new RecordedRun(simulated.Session);

            simulated.Run(2, (frame, _) => expected.Add(frame.DisplayTime.HasValue ? frame.ClockError.Ticks * 100 : (long?)null));
            run.Close();

            Assert.That(run.Of("frame").Select(f => (long?)f["estimated_error_ns"]), Is.EqualTo(expected));
            Assert.That(expected.First(), Is.Null);
            Assert.That(expected.Last(), Is.InRange(1_000, 20_000_000));
        }

        [Test]
        public void Exchange_CoarseClock_IsWrittenAsReceived()
        {
            var session = NewSession();
            var run = new RecordedRun(session);

            session.Clock.Add(Exchange(Start, resolutionMs: 1), out _);
            session.Clock.Add(Exchange(Start, resolutionMs: 1), out _);
            run.Close();

            var first = run.Of("sync")[0];
            Assert.That((long)first["t2_ns"], Is.EqualTo(100_000_000_000));
            Assert.That((long)first["resolution_ns"], Is.EqualTo(1_000_000));
            Assert.That((long)first["server_bound_ns"], Is.EqualTo(300_000));
            Assert.That((string)first["verdict"], Is.EqualTo("consistent"));
            Assert.That((string)run.Of("sync")[1]["fault"], Is.EqualTo("not_newer"));
        }

        [Test]
        public void Sample_DroppedWithVelocities_IsWrittenWithItsReason()
        {
            var session = NewSession();
            var run = new RecordedRun(session);
            var message = new JointStateMessage(
                new ControlTime(Start.SinceEpoch), new[] { "elbow", "shoulder" }, new[] { 0.1, 1 / 3.0 }, new[] { double.NaN, -2e-7 });

            session.Listener.Received(message, Start);
            session.Listener.Received(message, Start);
            session.Tick(Start);
            run.Close();

            var samples = run.Of("sample");
            Assert.That(samples[0]["velocity"].Select(v => (double?)v), Is.EqualTo(new double?[] { null, -2e-7 }));
            Assert.That((double)samples[0]["position"][1], Is.EqualTo(1 / 3.0));
            Assert.That(samples[0]["dropped"], Is.Null);
            Assert.That((string)samples[1]["dropped"], Is.EqualTo("duplicate_sample"));
            Assert.That((int)run.Of("drops").Single()["messages"]["duplicate_sample"], Is.EqualTo(1));
        }

        [Test]
        public void Plan_Received_IsWrittenUnchangedBeforeItsFrame()
        {
            var session = NewSession();
            var run = new RecordedRun(session);
            session.Clock.Add(Exchange(Start), out _);
            var stamp = new ControlTime(Start.SinceEpoch);

            session.Listener.Planned(new JointTrajectoryMessage(stamp, new[] { "elbow" }, new[]
            {
                new JointTrajectoryPoint(TimeSpan.Zero, new[] { 1 / 3.0 }, new[] { double.NaN }),
                new JointTrajectoryPoint(new TimeSpan(1234567), new[] { 0.5 }, null, new[] { -2e-7 }),
            }), Start - Lengths.Ms(3));
            session.Listener.Planned(new JointTrajectoryMessage(stamp, new[] { "wing" }, Array.Empty<JointTrajectoryPoint>()), Start);
            session.Listener.Planned(new JointTrajectoryMessage(stamp + Lengths.Ms(5000), new[] { "elbow" }, Array.Empty<JointTrajectoryPoint>()), Start);
            session.Tick(Start);
            run.Close();

            var plans = run.Of("plan");
            Assert.That(
                plans.Select(p => (string)p["dropped"]), Is.EqualTo(new[] { "unknown_joint", null, "stamp_in_future" }),
                "the plan with an unknown joint is checked on arrival");
            var plan = plans[1];
            Assert.That((long)plan["arrival_ns"], Is.EqualTo((Start - Lengths.Ms(3)).Nanoseconds));
            Assert.That((long)plan["stamp_ns"], Is.EqualTo(stamp.Nanoseconds));
            Assert.That(plan["names"].Select(n => (string)n), Is.EqualTo(new[] { "elbow" }));
            Assert.That(plan["points"].Select(p => (long)p["time_from_start_ns"]), Is.EqualTo(new[] { 0, 123_456_700 }));
            Assert.That((double)plan["points"][0]["position"][0], Is.EqualTo(1 / 3.0), "all digits are written");
            Assert.That((double?)plan["points"][0]["velocity"][0], Is.Null);
            Assert.That(plan["points"][0]["acceleration"], Is.Null);
            Assert.That((double)plan["points"][1]["acceleration"][0], Is.EqualTo(-2e-7));
            Assert.That(plans[2]["points"], Is.Empty);
            var kinds = run.Lines.Select(l => (string)l["kind"]).ToList();
            Assert.That(kinds.LastIndexOf("plan"), Is.LessThan(kinds.IndexOf("frame")));
            Assert.That((bool)run.Lines[0]["settings"]["follow_plan"]);
        }

        [Test]
        public void Lines_ClockStepAndDisplayChange_PrecedeTheirFrame()
        {
            var session = NewSession();
            var run = new RecordedRun(session);

            session.Clock.Add(Exchange(Start), out _);
            session.Tick(Start);
            session.Visualisation = VisualisationLatency.FromMilliseconds(55);
            session.Tick(Start + Lengths.Ms(16));
            run.Close();

            var kinds = run.Lines.Select(l => (string)l["kind"]).Where(k => k != "statistics");
            Assert.That(kinds, Is.EqualTo(new[] { "session", "sync", "clock", "display", "frame", "display", "frame", "end" }));
            Assert.That((bool)run.Of("clock").Single()["new_start"]);
            Assert.That((long)run.Of("display")[1]["l_visu_ns"], Is.EqualTo(55_000_000));
        }
    }
}
