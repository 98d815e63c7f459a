using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class JointWatchTests
    {
        const int Seed = 7;

        static SimulatedSession Running(bool isEachJointApart = false)
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed) { IsEachJointApart = isEachJointApart };
            simulated.Run(10);
            Assert.That(simulated.Session.Tick(HeadsetTime.FromSeconds(simulated.Now)).State, Is.EqualTo(PoseState.Current), "at the start, seed " + Seed);
            return simulated;
        }

        static List<PoseState> StatesOf(SimulatedSession simulated, double seconds)
        {
            var states = new List<PoseState>();
            simulated.Run(seconds, (frame, light) => states.Add(frame.State));
            return states;
        }

        static SessionStatistics StatisticsOf(SimulatedSession simulated) => simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

        static ControlTime ControlNow(SimulatedSession simulated)
        {
            var now = HeadsetTime.FromSeconds(simulated.Now);
            return simulated.Link.TrueOffset(now).ToControl(now);
        }

        static void Report(SimulatedSession simulated, params JointReport[] joints) =>
            simulated.Session.Listener.StatusReceived(new JointStatusMessage(joints), HeadsetTime.FromSeconds(simulated.Now));

        static void Report(SimulatedSession simulated, string joint, JointDataState state, double secondsAgo = 0, string reason = "") =>
            Report(simulated, new JointReport(joint, state, ControlNow(simulated) - Lengths.Seconds(secondsAgo), reason));

        [TestCase(false)]
        [TestCase(true)]
        public void Tick_SamplesOfOneJointStop_HoldsThePoseAndNamesTheJoint(bool isEachJointApart)
        {
            var simulated = Running(isEachJointApart);

            simulated.SilentJoint = "elbow";
            // Samples that were taken before the joint stopped sending still arrive, up to 105 ms plus the delay of the WiFi after they were taken.
            var states = StatesOf(simulated, 0.3 + 0.15);
            var after = StatesOf(simulated, 3);
            var statistics = StatisticsOf(simulated);

            Assert.That(states.Last(), Is.EqualTo(PoseState.Held));
            Assert.That(after, Is.All.EqualTo(PoseState.Held));
            var joint = statistics.JointStatuses.Single();
            Assert.That(joint.Joint, Is.EqualTo("elbow"));
            Assert.That(joint.State, Is.EqualTo(JointDataState.Stale));
            Assert.That(joint.IsMissing);
            Assert.That(joint.Age.Value.TotalSeconds, Is.InRange(3.3, 3.7), "the age counts from the last sample of this joint");
        }

        [Test]
        public void Tick_SamplesReturn_IsCurrentAndReportsNoJoint()
        {
            var simulated = Running();
            simulated.SilentJoint = "shoulder";
            simulated.Run(3);

            simulated.SilentJoint = null;
            simulated.Run(1);

            Assert.That(StatesOf(simulated, 1), Is.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses, Is.Empty);
        }

        [Test]
        public void Fill_JointNeverReceived_IsMissingWithoutAge()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { SilentJoint = "shoulder" };
            simulated.Run(5);

            var joint = StatisticsOf(simulated).JointStatuses.Single();

            Assert.That(joint.Joint, Is.EqualTo("shoulder"));
            Assert.That(joint.State, Is.EqualTo(JointDataState.Missing));
            Assert.That(joint.Age, Is.Null);
            Assert.That(joint.Description, Is.EqualTo("no value"));
        }

        [TestCase(JointDataState.Fault)]
        [TestCase(JointDataState.Refused)]
        [TestCase(JointDataState.Missing)]
        [TestCase(JointDataState.Stale)]
        public void Tick_GatewayReportsNoData_IsHeldBeforeTheSamplesAreTooOld(JointDataState state)
        {
            var simulated = Running();

            Report(simulated, "elbow", state, 2.5, "node deleted");
            var states = StatesOf(simulated, 0.05);
            var joint = StatisticsOf(simulated).JointStatuses.Single();

            Assert.That(states, Is.All.EqualTo(PoseState.Held));
            Assert.That(joint.Joint, Is.EqualTo("elbow"));
            Assert.That(joint.State, Is.EqualTo(state));
            Assert.That(joint.Age.Value.TotalSeconds, Is.EqualTo(2.55).Within(0.02));
            Assert.That(joint.Reason, Is.EqualTo("node deleted"));
        }

        [Test]
        public void Tick_GatewayReportsRest_StaysCurrentAndReportsTheRest()
        {
            var simulated = Running();

            Report(simulated, "elbow", JointDataState.Rest, 12);
            var states = StatesOf(simulated, 0.5);
            var joint = StatisticsOf(simulated).JointStatuses.Single();

            Assert.That(states, Is.All.EqualTo(PoseState.Current));
            Assert.That(joint.IsMissing, Is.False);
            Assert.That(joint.Description, Is.EqualTo("assumed at rest for 12 s"));
        }

        [Test]
        public void Tick_GatewayReportsRestButSamplesStop_PoseIsHeldAndJointBecomesStale()
        {
            var simulated = Running();
            simulated.SilentJoint = "elbow";
            simulated.Run(1);

            Report(simulated, "elbow", JointDataState.Rest, 1);
            var states = StatesOf(simulated, 2.4);
            var during = StatisticsOf(simulated).JointStatuses.Single();
            simulated.Run(0.2);
            var after = StatisticsOf(simulated).JointStatuses.Single();

            Assert.That(states, Is.All.EqualTo(PoseState.Held));
            Assert.That(during.State, Is.EqualTo(JointDataState.Rest));
            Assert.That(during.IsMissing, Is.False);
            Assert.That(DiagnosticsOf(simulated)["missing_joints"], Is.EqualTo("elbow"), "2.6 s after the last report");
            Assert.That(after.State, Is.EqualTo(JointDataState.Stale));
        }

        [Test]
        public void Tick_ReportOfTheGatewayEnds_IsCurrentImmediately()
        {
            var simulated = Running();
            Report(simulated, "elbow", JointDataState.Fault);
            simulated.Run(1);

            Report(simulated);

            Assert.That(StatesOf(simulated, 0.5), Is.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses, Is.Empty);
        }

        [Test]
        public void Tick_ReportNotRepeatedForFiveSeconds_IsIgnored()
        {
            var simulated = Running();
            Report(simulated, "elbow", JointDataState.Fault);

            var until5 = StatesOf(simulated, 4.9);
            simulated.Run(0.2);
            var after = StatesOf(simulated, 0.5);

            Assert.That(until5, Is.All.EqualTo(PoseState.Held));
            Assert.That(after, Is.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses, Is.Empty);
        }

        [Test]
        public void Tick_ReportForAnUnknownJoint_IsIgnored()
        {
            var simulated = Running();

            Report(simulated, "rail", JointDataState.Fault);

            Assert.That(StatesOf(simulated, 0.5), Is.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses, Is.Empty);
        }

        [Test]
        public void Tick_GripperReportedInFault_PoseIsHeld()
        {
            var simulated = Running();

            Report(simulated, "grip", JointDataState.Fault);

            Assert.That(StatesOf(simulated, 0.5), Is.All.EqualTo(PoseState.Held));
        }

        [Test]
        public void Tick_GripperReportedStale_IsNamedAndThePoseStaysCurrent()
        {
            var simulated = Running();

            Report(simulated, "grip", JointDataState.Stale);

            Assert.That(StatesOf(simulated, 0.5), Is.All.EqualTo(PoseState.Current), "a joint of the gripper without samples does not make the pose stale");
            Assert.That(StatisticsOf(simulated).JointStatuses.Single().State, Is.EqualTo(JointDataState.Stale));
            Assert.That(DiagnosticsOf(simulated)["missing_joints"], Is.EqualTo("grip"));
        }

        [Test]
        public void Fill_StartInTheFuture_HasAgeZero()
        {
            var simulated = Running();

            Report(simulated, "elbow", JointDataState.Fault, -30);

            Assert.That(StatisticsOf(simulated).JointStatuses.Single().Age.Value.Ticks, Is.Zero);
        }

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

        [Test]
        public void Diagnostics_SeveralJointsWithoutData_AreSeparatedByCommas()
        {
            var simulated = Running();
            simulated.IsGatewayUp = false;
            simulated.Run(2);

            Assert.That(DiagnosticsOf(simulated)["missing_joints"], Is.EqualTo("shoulder,elbow"));
        }

        static Dictionary<string, string> DiagnosticsOf(SimulatedSession simulated) =>
            SessionDiagnostics.Of(StatisticsOf(simulated), "left", default).Values.ToDictionary(each => each.Key, each => each.Value);

        [Test]
        public void Diagnostics_CurrentPoseWithAProblem_AreAWarningWithThePanelsText()
        {
            (int, string) StatusOf(SessionStatistics statistics)
            {
                statistics.Pose = PoseState.Current;
                var message = SessionDiagnostics.Of(statistics, "left", default);
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
            DiagnosticsMessage Diagnostics() => SessionDiagnostics.Of(StatisticsOf(simulated), "left", default);
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
            var statistics = new SessionStatistics { Pose = PoseState.Current, IsDisplayTimeImplausible = true };
            const string reason = StateNames.UncertainRestReason + "nothing confirms the last value";
            statistics.ChangeableJointStatuses.Add(new JointStatus("elbow", JointDataState.Rest, null, null, reason));

            var message = SessionDiagnostics.Of(statistics, "left", default);

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
