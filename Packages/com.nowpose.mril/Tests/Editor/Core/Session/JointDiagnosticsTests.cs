using System;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Cell;
using Nowpose.Sync;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.WatchedSession;

namespace Nowpose.Tests.Core.Session
{
    public class JointDiagnosticsTests
    {
        [Test]
        public void Diagnostics_JointWithoutData_ContainPoseStateMissingJointAndCurrentShare()
        {
            var simulated = Running();
            var before = DiagnosticsOf(simulated);

            simulated.SilentJoint = "elbow";
            simulated.Run(6);
            Report(simulated, "shoulder", JointDataState.Rest, 12);
            var after = DiagnosticsOf(simulated);

            Assert.That(before["pose"], Is.EqualTo("current"));
            Assert.That(before["missing_joints"], Is.Empty);
            Assert.That(after["pose"], Is.EqualTo("held"));
            Assert.That(after["missing_joints"], Is.EqualTo("elbow"));
            Assert.That(after["joint_status/elbow"], Is.EqualTo("no data for 6 s"));
            Assert.That(after["joint_status/shoulder"], Is.EqualTo("assumed at rest for 12 s"));
            Assert.That(double.Parse(after["current_share"], System.Globalization.CultureInfo.InvariantCulture), Is.EqualTo(0.43).Within(0.06));
        }

        // The thread of the connection goes on, for example while the application loads a scene.
        [TestCase(0.5, "current", 0)]
        [TestCase(12, "held", 1)]
        public void Diagnostics_FramesMissing_AreNotCurrent(double seconds, string pose, int level)
        {
            var simulated = Running();
            var now = HeadsetTime.FromSeconds(simulated.Now + seconds);

            var diagnostics = SessionDiagnostics.Of(simulated.Session.Statistics(now), CellFaults.None, "left", default);

            Assert.That(diagnostics.Values.Single(each => each.Key == "pose").Value, Is.EqualTo(pose));
            Assert.That(diagnostics.Values.Count(each => each.Key is "horizon_ms" or "current_share"), Is.EqualTo(pose == "current" ? 2 : 0));
            Assert.That(diagnostics.Level, Is.EqualTo(level));
            Assert.That(diagnostics.Message, level == 0 ? Is.Empty : Does.Contain(DisplayMessages.NoFrames(Lengths.Seconds(seconds))));
            Assert.That(simulated.Session.ReadWorstPose(now), Is.EqualTo(level == 0 ? PoseState.Current : PoseState.Held));
        }

        [Test]
        public void Diagnostics_SeveralJointsWithoutData_AreSeparatedByCommas()
        {
            var simulated = Running();
            simulated.IsGatewayUp = false;
            simulated.Run(2);

            Assert.That(DiagnosticsOf(simulated)["missing_joints"], Is.EqualTo("shoulder,elbow"));
        }

        [Test]
        public void Diagnostics_CurrentPoseWithAProblem_AreAWarningWithThePanelsText()
        {
            (int, string) StatusOf(SessionStatistics statistics)
            {
                statistics.WorstPose = PoseState.Current;
                var message = SessionDiagnostics.Of(statistics, CellFaults.None, "left", default);
                return (message.Level, message.Message);
            }
            var watch = new LimitWatch(TestRobot.Model);
            for (var i = 0; i < 3; i++) watch.Add(0, 45);
            var profile = new LatencyProfile(40, 1, new DisplayConditions(graphicsApi: "Direct3D11"), DateTime.UnixEpoch, CalibrationMethod.Sine, 1);
            var mismatches = profile.MismatchesWith(new DisplayConditions(graphicsApi: "Vulkan"));
            var implausible = new SessionStatistics { IsDisplayTimeImplausible = true };

            Assert.That(StatusOf(new SessionStatistics()), Is.EqualTo((0, "")));
            Assert.That(StatusOf(new SessionStatistics { BeyondLimits = watch.Present }), Is.EqualTo((1, watch.Present.Words)));
            Assert.That(StatusOf(new SessionStatistics { ProfileMismatches = mismatches }), Is.EqualTo((1, mismatches[0].Words)));
            Assert.That(StatusOf(new SessionStatistics { ProfileMismatches = mismatches, IsLightPredicted = true }), Is.EqualTo((0, "")));
            Assert.That(StatusOf(implausible), Is.EqualTo((1, DisplayMessages.ProblemOf(implausible))));
        }

        [Test]
        public void Diagnostics_RestUncertain_AreAWarningThatNamesTheJointsUntilTheRestIsCertain()
        {
            var simulated = Running();
            DiagnosticsMessage Diagnostics() => SessionDiagnostics.Of(StatisticsOf(simulated), CellFaults.None, "left", default);
            JointReport Rest(string joint, string reason) => new JointReport(joint, JointDataState.Rest, ControlNow(simulated) - Lengths.Seconds(9), reason);
            const string reason = StateNames.UncertainRestReason + "the stop itself was not observed";

            Report(simulated, Rest("shoulder", reason), Rest("elbow", reason));
            simulated.Run(0.5);
            var both = Diagnostics();
            Report(simulated, Rest("shoulder", "no change is reported"), Rest("elbow", reason));
            var one = Diagnostics();
            Report(simulated, Rest("shoulder", "no change is reported"), Rest("elbow", ""));
            var certain = Diagnostics();

            Assert.That((both.Level, both.Message), Is.EqualTo((1, "joints shoulder, elbow: " + reason)));
            Assert.That((one.Level, one.Message), Is.EqualTo((1, "joint elbow: " + reason)));
            Assert.That((certain.Level, certain.Message), Is.EqualTo((0, "")));
            Assert.That(both.Values.Single(pair => pair.Key == "pose").Value, Is.EqualTo("current"));
        }

        [Test]
        public void Diagnostics_RestUncertainAndADisplayProblem_ContainBoth()
        {
            var statistics = new SessionStatistics { WorstPose = PoseState.Current, IsDisplayTimeImplausible = true };
            const string reason = StateNames.UncertainRestReason + "nothing confirms the last value";
            statistics.OwnRobot.JointStatuses.Add(new JointStatus("elbow", JointDataState.Rest, null, null, reason));

            var message = SessionDiagnostics.Of(statistics, CellFaults.None, "left", default);

            Assert.That((message.Level, message.Message), Is.EqualTo((1, "joint elbow: " + reason + "; " + DisplayMessages.ProblemOf(statistics))));
        }

        [Test]
        public void HasPoseChanged_PoseIsHeldAndCurrentAgain_IsTrueUntilTheNextDiagnostics()
        {
            var simulated = Running();
            var listener = new SessionListener(simulated.Session, new SetClock { Now = HeadsetTime.FromSeconds(simulated.Now) });
            var beforeTheFirst = listener.HasPoseChanged;
            listener.Diagnostics();
            var unchanged = listener.HasPoseChanged;

            Report(simulated, "elbow", JointDataState.Fault);
            simulated.Run(0.1);
            var held = listener.HasPoseChanged;
            listener.Diagnostics();
            var reported = listener.HasPoseChanged;
            Report(simulated);
            simulated.Run(0.1);

            Assert.That(
                new[] { beforeTheFirst, unchanged, held, reported, listener.HasPoseChanged }, Is.EqualTo(new[] { false, false, true, false, true }));
        }

        [TestCase(PoseState.Current, ClockState.Synchronised, 0.4, "current")]
        [TestCase(PoseState.Current, ClockState.Coarse, 0.9, "coarse")]
        [TestCase(PoseState.Current, ClockState.Holdover, 0.9, "current")]
        [TestCase(PoseState.Current, ClockState.Holdover, 3, "coarse")]
        [TestCase(PoseState.Held, ClockState.Synchronised, 0.4, "held")]
        [TestCase(PoseState.Unsynchronised, ClockState.Converging, 20, "unsynchronised")]
        [TestCase(PoseState.Incomplete, ClockState.Unsynchronised, 0, "incomplete")]
        [TestCase(PoseState.OutsideRange, ClockState.Synchronised, 0.4, "outside")]
        public void PoseStateName_EachState_EqualsTheNameInTheProtocol(PoseState pose, ClockState state, double errorMs, string expected)
        {
            var error = TimeSpan.FromTicks((long)(errorMs * TimeSpan.TicksPerMillisecond));

            var statistics = new SessionStatistics { Pose = pose, Clock = new ClockModel(default, default, 0, error, state) };

            Assert.That(PoseStateName.Of(statistics), Is.EqualTo(expected));
        }

        [TestCase(5, "current")]
        [TestCase(1, "coarse")]
        public void PoseStateName_Holdover_UsesTheLimitOfTheSession(double errorToSynchroniseMs, string expected)
        {
            var statistics = new SessionStatistics
            {
                Pose = PoseState.Current,
                Clock = new ClockModel(default, default, 0, TimeSpan.FromMilliseconds(3), ClockState.Holdover),
                ClockSettings = new ClockSettings(errorToSynchroniseMs: errorToSynchroniseMs),
            };

            Assert.That(PoseStateName.Of(statistics), Is.EqualTo(expected));
        }
    }
}
