using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Tests.Core.Session;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using Nowpose.Unity.Rendering;
using Nowpose.Unity.Status;
using NUnit.Framework;
using static Nowpose.Tests.Core.Lengths;
using static Nowpose.Tests.Unity.Status.StatusRows;

namespace Nowpose.Tests.Unity.Status
{
    /// <summary>Tests the rows of the status panel.</summary>
    public class StatusTextsTests
    {
        static readonly SessionSettings Plain = new SessionSettings(new ConnectionSettings("192.168.0.5", insecureLan: true), default);

        [Test]
        public void Update_JointBeyondItsLimits_IsShownUnlessThereIsAWorseProblem()
        {
            var watch = new LimitWatch(TestRobot.Model);
            for (var i = 0; i < 3; i++) watch.Add(0, 45);
            var statistics = new SessionStatistics { BeyondLimits = watch.Present, RobotDescriptionMatch = RobotDescriptionMatch.Same };
            var texts = new StatusTexts();

            texts.Update(statistics, Loopback, "test", null);
            var shownMessage = texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
            texts.Update(statistics, Loopback, "test", "settings: worse");

            Assert.That(texts.ValueOf(StatusRow.Robot), Is.EqualTo(StatusMessages.BeyondLimits));
            Assert.That(shownMessage, Is.EqualTo("! " + RobotMessages.BeyondLimits("shoulder", 45, "rad", -3, 3, "degrees")));
            Assert.That(texts.ValueOf(StatusRow.Message), Is.EqualTo("! settings: worse"));
        }

        [Test]
        public void Update_GatewayServesOtherNamespaces_NamesThemUnlessTheConnectionHasFailed()
        {
            var statistics = new SessionStatistics { SampleLink = LinkStatus.Connected };
            statistics.OwnRobot.OtherNamespaces = RobotMessages.OtherNamespaces("", new[] { "arm1", "arm2" });
            var texts = new StatusTexts();

            texts.Update(statistics, Loopback, "test", null);
            var connected = texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
            statistics.SampleLink = LinkStatus.Waiting("joint positions: " + ConnectionMessages.Closed());
            texts.Update(statistics, Loopback, "test", null);

            Assert.That(connected, Is.EqualTo("! " + statistics.OwnRobot.OtherNamespaces));
            Assert.That(texts.ValueOf(StatusRow.Message).Replace('\n', ' '), Is.EqualTo("! joint positions: " + ConnectionMessages.Closed()));
        }

        [Test]
        public void Update_ProfileForOtherConditions_IsMarkedUnlessTheDisplayTimeIsPredicted()
        {
            var conditions = new DisplayConditions(graphicsApi: "Direct3D11", reprojection: ReprojectionMode.Depth);
            var profile = new LatencyProfile(40, 1, conditions, DateTime.UtcNow, CalibrationMethod.Sine, 1);
            var mismatches = profile.MismatchesWith(new DisplayConditions(graphicsApi: "Vulkan", reprojection: ReprojectionMode.None));
            var statistics = new SessionStatistics { VisualisationLatency = Ms(40), Profile = profile, ProfileMismatches = mismatches };
            var texts = new StatusTexts();

            texts.Update(statistics, Loopback, "test", null);
            var row = texts.ValueOf(StatusRow.VisualisationLatency) + "|" + texts.NoteOf(StatusRow.VisualisationLatency);
            var shownMessage = texts.ValueOf(StatusRow.Message).Replace('\n', ' ');
            statistics.IsLightPredicted = true;
            texts.Update(statistics, Loopback, "test", null);

            Assert.That(row, Is.EqualTo("! 40.0 ms|other graphics API"));
            Assert.That(shownMessage, Is.EqualTo("! " + mismatches[0].Words));
            Assert.That(texts.ValueOf(StatusRow.VisualisationLatency) + texts.ValueOf(StatusRow.Message), Is.EqualTo("40.0 ms"));
        }

        [Test]
        public void Update_GatewayOfAnotherVersion_ShowsTheMismatch()
        {
            var statistics = new SessionStatistics { VersionMismatch = NowposeVersion.MismatchOf("9.9.9", "the gateway", "this headset") };
            var texts = new StatusTexts();

            texts.Update(statistics, Loopback, "test", null);

            Assert.That(texts.ValueOf(StatusRow.Message).Replace('\n', ' '), Is.EqualTo("! " + statistics.VersionMismatch));
        }

        [Test]
        public void Update_NewSession_ShowsUnknownValues()
        {
            Assert.That(Row(StatusRow.Pose), Does.StartWith("! " + PoseMessages.Of(PoseState.Incomplete)));
            Assert.That(Row(StatusRow.Clock), Is.EqualTo(StatusMessages.Of(ClockState.Unsynchronised) + "|"));
            Assert.That(Row(StatusRow.ApplicationLatency), Is.EqualTo("–|"));
            Assert.That(Row(StatusRow.Horizon), Is.EqualTo("–|"));
            Assert.That(Row(StatusRow.RenderTime), Is.EqualTo("–|" + RenderTimeNames.NameOf(RenderTimeSourceKind.None)));
            Assert.That(Row(StatusRow.Reduction), Is.EqualTo("–|"));
            Assert.That(Row(StatusRow.Error), Is.EqualTo("–|"));
            Assert.That(Row(StatusRow.Connection), Does.StartWith(StatusMessages.Of(LinkState.Idle, LinkState.Idle) + "|"));
            Assert.That(Row(StatusRow.Robot), Is.EqualTo("–|"));
        }

        [TestCase(PoseState.Current, "current")]
        [TestCase(PoseState.OutsideRange, "! outside range")]
        [TestCase(PoseState.Held, "! held")]
        [TestCase(PoseState.Unsynchronised, "! not synchronised")]
        [TestCase(PoseState.Incomplete, "! no positions yet")]
        public void Update_PoseState_ShowsItsTextAndMarksAProblem(PoseState pose, string value)
        {
            var row = Row(StatusRow.Pose, new SessionStatistics { SettledPose = pose }).Split('|');

            Assert.That(row[0], Is.EqualTo(value));
            Assert.That(row[1].Length > 0, Is.EqualTo(pose != PoseState.Current), "the note states the reason");
            Assert.That(value, Does.EndWith(pose == PoseState.Current ? "current" : PoseLook.Of(pose).Label),
                "the words that are displayed at the robot");
        }

        [TestCase(ClockState.Synchronised, "synchronised|± 0.35 ms")]
        [TestCase(ClockState.Coarse, "coarse|± 0.35 ms")]
        [TestCase(ClockState.Converging, "! converging|± 0.35 ms")]
        [TestCase(ClockState.Holdover, "! holdover|± 0.35 ms")]
        [TestCase(ClockState.Unsynchronised, "! no response yet|")]
        public void Update_Clock_ShowsItsEstimatedErrorOnceKnown(ClockState state, string expected)
        {
            var clock = new ClockModel(default, default, 0, Ms(8), state, estimatedError: Ms(0.35));

            Assert.That(Row(StatusRow.Clock, new SessionStatistics { Clock = clock }), Is.EqualTo(expected));
        }

        [TestCase(PoseState.Current, ClockState.Coarse, "current|clock ± 3.1 ms")]
        [TestCase(PoseState.Current, ClockState.Holdover, "current|clock ± 3.1 ms")]
        [TestCase(PoseState.Current, ClockState.Synchronised, "current|")]
        [TestCase(PoseState.Held, ClockState.Coarse, "! held|" + StatusMessages.TooFewSamples)]
        public void Update_PoseWithACoarseClock_ShowsTheErrorBesideThePose(PoseState pose, ClockState state, string expected)
        {
            var clock = new ClockModel(default, default, 0, Ms(14), state, estimatedError: Ms(3.14));

            Assert.That(Row(StatusRow.Pose, new SessionStatistics { SettledPose = pose, Clock = clock }), Is.EqualTo(expected));
        }

        [Test]
        public void Update_Latencies_AreInMilliseconds()
        {
            var statistics = new SessionStatistics
            {
                ApplicationLatency = Ms(83.44), ApplicationLatency95 = Ms(110.4), VisualisationLatency = Ms(40), Horizon = Ms(-3.2),
            };

            Assert.That(Row(StatusRow.ApplicationLatency, statistics), Is.EqualTo("83.4 ms|95 % below 110 ms"));
            Assert.That(Row(StatusRow.VisualisationLatency, statistics), Does.StartWith("40.0 ms|"));
            Assert.That(Row(StatusRow.Horizon, statistics), Is.EqualTo("−3 ms|"));
        }

        [TestCase(CalibrationMethod.VisibleLight, "40.2 ms|by visible light, 2026-11-20")]
        [TestCase(CalibrationMethod.Sine, "40.2 ms|by sine jog, 2026-11-20")]
        [TestCase(CalibrationMethod.Nudge, "40.2 ms|by eye, 2026-11-20")]
        [TestCase(CalibrationMethod.Manual, "40.2 ms|by hand, 2026-11-20")]
        public void Update_VisualisationLatencyOfAProfile_ShowsMethodAndDate(object method, string expected)
        {
            var profile = new LatencyProfile(40.2, 1, "", 0, new DateTime(2026, 11, 20, 23, 0, 0, DateTimeKind.Utc), (CalibrationMethod)method, 3);

            Assert.That(Row(StatusRow.VisualisationLatency, new SessionStatistics { VisualisationLatency = Ms(40.2), Profile = profile }), Is.EqualTo(expected));
        }

        [TestCase(false, false, false, "47.0 ms|" + StatusMessages.LatencySet)]
        [TestCase(true, false, false, "47.0 ms|" + StatusMessages.LatencyPredicted)]
        [TestCase(true, true, false, "47.0 ms|" + StatusMessages.LatencyNotVerified)]
        [TestCase(true, true, true, "! 47.0 ms|" + StatusMessages.LatenciesDiffer)]
        public void Update_VisualisationLatency_NamesItsSource(bool isPredicted, bool isInconsistent, bool isCalibrated, string expected)
        {
            var statistics = new SessionStatistics
            {
                VisualisationLatency = Ms(47), IsLightPredicted = isPredicted, IsDisplayTimeInconsistent = isInconsistent,
                Profile = isCalibrated ? new LatencyProfile(40, 1, "", 0, DateTime.UnixEpoch, CalibrationMethod.Nudge, 3) : null,
            };
            Assert.That(Row(StatusRow.VisualisationLatency, statistics), Is.EqualTo(expected));
        }

        [TestCase(OutsideRangeResponse.Fade)]
        [TestCase(OutsideRangeResponse.GoOn)]
        [TestCase(OutsideRangeResponse.Hold)]
        public void Update_PoseOutsideRange_HasTheTextOfPoseAppearance(OutsideRangeResponse response)
        {
            var row = Row(StatusRow.Pose, new SessionStatistics { SettledPose = PoseState.OutsideRange, OutsideRange = response }).Split('|');

            Assert.That(row[0], Is.EqualTo("! " + PoseLook.Of(PoseState.OutsideRange, response).Label));
            Assert.That(row[1], Is.EqualTo(StatusMessages.FramesLate));
        }

        [TestCase(RenderTimeSourceKind.DisplayGpuTime, "9.5 ms|GPU time from headset")]
        [TestCase(RenderTimeSourceKind.EngineGpuTime, "9.5 ms|GPU time from Unity")]
        [TestCase(RenderTimeSourceKind.GpuCompletion, "9.5 ms|time to GPU completion")]
        [TestCase(RenderTimeSourceKind.CameraCpu, "9.5 ms|camera CPU, unverified")]
        public void Update_RenderTime_NamesItsSource(RenderTimeSourceKind source, string expected)
        {
            Assert.That(Row(StatusRow.RenderTime, new SessionStatistics { RenderTime = Ms(9.5), RenderTimeSource = source }), Is.EqualTo(expected));
        }

        [TestCase(RangeState.Inside, RangeUnknownReason.None, "inside|")]
        [TestCase(RangeState.Outside, RangeUnknownReason.None, "! outside|")]
        [TestCase(RangeState.Unknown, RangeUnknownReason.NoLimit, "–|" + StatusMessages.NoLimit)]
        [TestCase(RangeState.Unknown, RangeUnknownReason.NoRenderTime, "–|not measured")]
        [TestCase(RangeState.Unknown, RangeUnknownReason.TooFewFrames, "–|measuring")]
        [TestCase(RangeState.Unknown, RangeUnknownReason.LongerThanRefresh, "–|" + StateNames.FramesMissRefreshes)]
        [TestCase(RangeState.Outside, RangeUnknownReason.LowFrameRate, "! outside|" + StateNames.FramesMissRefreshes)]
        [TestCase(RangeState.Unknown, RangeUnknownReason.BeyondMeasured, "–|" + StateNames.BeyondMeasured)]
        [TestCase(RangeState.Unknown, RangeUnknownReason.OtherSource, "–|" + StateNames.OtherSourceLimit)]
        public void Update_Range_ShowsTheReasonIfUnknown(RangeState range, object reason, string expected)
        {
            Assert.That(Row(StatusRow.Range, new SessionStatistics { Range = range, RangeUnknownReason = (RangeUnknownReason)reason }), Is.EqualTo(expected));
        }

        static readonly LinkStatus Failed = LinkStatus.Waiting("clock sync: refused");

        static IEnumerable<TestCaseData> Links()
        {
            yield return new TestCaseData(LinkStatus.Idle, LinkStatus.Idle, "not connected", "");
            yield return new TestCaseData(LinkStatus.Connecting, LinkStatus.Connecting, "connecting", "");
            yield return new TestCaseData(LinkStatus.Connected, LinkStatus.Connecting, "connecting", "");
            yield return new TestCaseData(LinkStatus.Connected, LinkStatus.Connected, "connected", "");
            yield return new TestCaseData(Failed, LinkStatus.Connected, "! trying again", "! clock sync: refused");
            yield return new TestCaseData(LinkStatus.Connected, Failed, "! trying again", "! clock sync: refused");
        }

        [TestCaseSource(nameof(Links))]
        public void Update_Connections_ShowsTheWorseState(LinkStatus sync, LinkStatus samples, string value, string message)
        {
            var texts = new StatusTexts();

            texts.Update(new SessionStatistics { SyncLink = sync, SampleLink = samples }, Loopback, null, null);

            Assert.That(texts.ValueOf(StatusRow.Connection), Is.EqualTo(value));
            Assert.That(texts.ValueOf(StatusRow.Message), Is.EqualTo(message));
        }

        [Test]
        public void Update_Security_MarksPlainTextOverANetwork()
        {
            string Note(TransportSecurity security, SessionSettings settings) =>
                Row(StatusRow.Connection, new SessionStatistics { Security = security }, settings).Split('|')[1];

            Assert.That(Note(TransportSecurity.Pinned, Plain), Is.EqualTo("encrypted, pinned key"));
            Assert.That(Note(TransportSecurity.DeviceTrust, Plain), Is.EqualTo("encrypted, device trust"));
            Assert.That(Note(TransportSecurity.Plain, Plain), Is.EqualTo("! not encrypted"));
            Assert.That(Note(TransportSecurity.Plain, Loopback), Is.EqualTo("within this machine"));
        }

        [TestCase(RobotDescriptionMatch.Same, StatusMessages.SameRobot + "|youBot")]
        [TestCase(RobotDescriptionMatch.Different, "! differs|youBot")]
        [TestCase(RobotDescriptionMatch.Unknown, "–|youBot")]
        public void Update_Robot_ShowsWhetherTheDescriptionMatches(object match, string expected)
        {
            var statistics = new SessionStatistics { RobotDescriptionMatch = (RobotDescriptionMatch)match };
            Assert.That(Row(StatusRow.Robot, statistics, robot: "youBot"), Is.EqualTo(expected));
        }

        [Test]
        public void Update_Problem_IsWrappedAndRemovedAgain()
        {
            var texts = new StatusTexts();
            texts.Update(null, null, null, "visualisation latency: 900 ms is out of range; allowed: 0 to 500 ms; calibrate it for this device");
            var lines = texts.ValueOf(StatusRow.Message).Split('\n');

            texts.Update(null, null, null, null);

            Assert.That(lines.Length, Is.GreaterThan(1));
            Assert.That(lines.Max(l => LetterWidths.Of(l)), Is.LessThanOrEqualTo(PanelCells.MessageWidth));
            Assert.That(texts.MessageLines, Is.Zero);
            Assert.That(texts.ValueOf(StatusRow.Message), Is.Empty);
        }

        [Test]
        public void Texts_All_FitTheirColumns()
        {
            var values = new List<string>();
            var notes = new List<string>();
            var texts = new StatusTexts();
            for (var pose = PoseState.Incomplete; pose <= PoseState.Current; pose++)
                for (var clock = ClockState.Unsynchronised; clock <= ClockState.Holdover; clock++)
                    for (var reason = RangeUnknownReason.None; reason <= RangeUnknownReason.LowFrameRate; reason++)
                    {
                        var model = new ClockModel(default, default, 0, Ms(0.35), clock);
                        texts.Update(new SessionStatistics { SettledPose = pose, Clock = model, RangeUnknownReason = reason }, Plain, "", null);
                        for (var row = StatusRow.Pose; row < StatusRow.Message; row++)
                        {
                            values.Add(texts.ValueOf(row));
                            notes.Add(texts.NoteOf(row));
                        }
                    }

            Assert.That(values.Max(v => LetterWidths.Of(v)), Is.LessThanOrEqualTo(9.3f), "each value fits into the column of 9.6 font sizes");
            Assert.That(notes.Max(n => LetterWidths.Of(n)), Is.LessThanOrEqualTo(PanelCells.NoteWidth));
        }
    }
}
