using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Cell;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.WatchedSession;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests joints that another clock stamps, and joints with no sample since a restart of the clock.</summary>
    public class JointStampTests
    {
        static SimulatedSession Running(double stampErrorSeconds, string predictor = "quadratic")
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, predictor) { StampErrorSeconds = stampErrorSeconds };
            simulated.Session.Listener.Connected(HeadsetTime.FromSeconds(0));
            simulated.Run(10);
            return simulated;
        }

        static void Receive(SimulatedSession simulated, string joint, double age)
        {
            var message = new JointStateMessage(ControlNow(simulated) - Lengths.Seconds(age), new[] { joint }, new[] { 0.03 });
            simulated.Session.Listener.Received(message, HeadsetTime.FromSeconds(simulated.Now));
        }

        static DiagnosticsMessage MessageOf(SimulatedSession simulated) =>
            SessionDiagnostics.Of(StatisticsOf(simulated), CellFaults.None, "left", default);

        [TestCase(0.2, "quadratic", PoseState.Current)]
        [TestCase(0.4, "quadratic", PoseState.Held)]
        [TestCase(0.4, "adaptive", PoseState.Current)]
        [TestCase(2, "quadratic", PoseState.Incomplete)]
        public void Statistics_StampsAheadOfTheControlClock_ReportTheClockOfTheSource(double ahead, string predictor, PoseState pose)
        {
            var simulated = Running(ahead, predictor);

            var statistics = StatisticsOf(simulated);
            var message = MessageOf(simulated);

            Assert.That(statistics.Pose, Is.EqualTo(pose));
            Assert.That(DisplayMessages.ProblemOf(statistics), Is.EqualTo(RobotMessages.StampsAhead));
            Assert.That(message.Level, Is.EqualTo(pose == PoseState.Incomplete ? 2 : 1));
            Assert.That(message.Message, Does.Contain(RobotMessages.StampsAhead));
        }

        [Test]
        public void Statistics_ClockOfTheSourceIsSet_ReportNothingTwoSecondsLater()
        {
            var simulated = Running(0.2);

            simulated.StampErrorSeconds = 0;
            simulated.Run(2.3);

            Assert.That(DisplayMessages.ProblemOf(StatisticsOf(simulated)), Is.Null);
        }

        // After a step of the control clock, stamps are ahead until the headset has detected the step.
        [TestCase(10, 0.1)]
        [TestCase(1.5, 0.4)]
        public void Statistics_StampsAheadByALatencyOrForASecond_ReportNothing(double seconds, double ahead)
        {
            var simulated = Running(0);

            simulated.StampErrorSeconds = ahead;
            simulated.Run(seconds);

            Assert.That(DisplayMessages.ProblemOf(StatisticsOf(simulated)), Is.Null);
        }

        [Test]
        public void Diagnostics_StampsOfAnotherRobotAhead_NameTheRobot()
        {
            var simulated = Running(0);
            RunWithSecondRobot(simulated, ahead: 0.15);

            Assert.That(StatisticsOf(simulated).WorstPose, Is.EqualTo(PoseState.Current));
            Assert.That(MessageOf(simulated).Message, Is.EqualTo(RobotMessages.OfRobot("arm2", RobotMessages.StampsAhead)));
        }

        [Test]
        public void Diagnostics_PoseIsNotCurrentBecauseStampsOfAnotherRobotAreAhead_NameTheRobot()
        {
            var simulated = Running(0);
            RunWithSecondRobot(simulated, ahead: 1.5);

            Assert.That(StatisticsOf(simulated).WorstPose, Is.EqualTo(PoseState.Incomplete));
            Assert.That(MessageOf(simulated).Message, Does.EndWith("; " + RobotMessages.OfRobot("arm2", RobotMessages.StampsAhead)));
        }

        static void RunWithSecondRobot(SimulatedSession simulated, double ahead)
        {
            var second = simulated.Session.Robots.Add("arm2", TestRobot.Model);
            for (var i = 0; i < 60; i++)
            {
                second.Intake.Add(
                    new JointStateMessage(ControlNow(simulated) + Lengths.Seconds(ahead), new[] { "shoulder", "elbow" }, new[] { 0.01 * i, 0.01 * i }),
                    HeadsetTime.FromSeconds(simulated.Now));
                simulated.Run(0.05);
            }
        }

        [Test]
        public void Horizon_GripperStampsAhead_IsThatOfTheArm()
        {
            var simulated = Running(0);

            Receive(simulated, "grip", age: -0.9);
            simulated.Run(0.1);

            Assert.That(StatisticsOf(simulated).Horizon.Value.TotalSeconds, Is.InRange(0.05, 0.25));
        }

        [TestCase(-10)]
        [TestCase(-600)]
        [TestCase(-1_699_999_000)]
        public void Statistics_StampsTooOldToBeDisplayed_ReportTheReasonAndTheLatency(double error)
        {
            var simulated = Running(error);

            var statistics = StatisticsOf(simulated);

            Assert.That(statistics.JointStatuses.Select(joint => (joint.Joint, joint.State, joint.Reason, joint.Since)), Is.EqualTo(new[]
            {
                ("shoulder", JointDataState.Stale, RobotMessages.SamplesTooOld, (ControlTime?)null),
                ("elbow", JointDataState.Stale, RobotMessages.SamplesTooOld, null),
            }));
            Assert.That(statistics.JointStatuses[0].Description, Is.EqualTo(StateNames.NotCurrent + ": " + RobotMessages.SamplesTooOld));
            Assert.That(statistics.Pose, Is.EqualTo(PoseState.Held));
            Assert.That(statistics.ApplicationLatency.Value.TotalSeconds, Is.EqualTo(0.08 - error).Within(0.1));
        }

        [Test]
        public void Statistics_OldSamplesOfASlowSource_ReportTheSameReasonUntilTheNext()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            simulated.Run(5);
            var reasons = new List<string>();

            for (var step = 0; step < 100; step++)
            {
                if (step % 7 == 0) foreach (var joint in new[] { "shoulder", "elbow" }) Receive(simulated, joint, age: 10);
                simulated.Run(0.1);
                if (step > 20) reasons.AddRange(StatisticsOf(simulated).JointStatuses.Select(joint => joint.Reason));
            }

            Assert.That(reasons, Has.Count.EqualTo(158).And.All.EqualTo(RobotMessages.SamplesTooOld));
        }

        [Test]
        public void Statistics_OldSamplesStop_ReportNoDataSinceTheNewestStamp()
        {
            var simulated = Running(-10);

            simulated.IsGatewayUp = false;
            simulated.Run(3.2);

            Assert.That(StatisticsOf(simulated).JointStatuses.Select(joint => joint.Reason), Is.All.Empty);
            Assert.That(StatisticsOf(simulated).JointStatuses.Select(joint => joint.Age.Value.TotalSeconds), Is.All.InRange(13, 13.3));
        }

        // The gateway sends the newest sample of a joint again after a reconnection.
        [Test]
        public void Statistics_OneOldSampleArrives_ReportNoDataSinceItsStamp()
        {
            var simulated = Running(0);
            simulated.SilentJoint = "elbow";
            simulated.Run(5);

            Receive(simulated, "elbow", age: 3);
            simulated.Run(0.1);

            var joint = StatisticsOf(simulated).JointStatuses.Single();
            Assert.That((joint.Joint, joint.Reason, Math.Round(joint.Age.Value.TotalSeconds, 1)), Is.EqualTo(("elbow", "", 3.1)));
        }

        [Test]
        public void SampleTaken_OldSamplesAfterAReconnection_OnlyTheFirstOfAJointHasNoLatency()
        {
            var simulated = Running(0);
            var latencies = new List<double?>();
            simulated.Session.Intake.SampleTaken += (arrival, latency) =>
            {
                if (arrival.Message.Names.Length == 1) latencies.Add(latency?.TotalSeconds);
            };

            simulated.Session.Listener.Connected(HeadsetTime.FromSeconds(simulated.Now));
            foreach (var age in new[] { 60, 59.5, 59 }) Receive(simulated, "grip", age);
            simulated.Run(0.1);

            Assert.That(latencies.Select(latency => latency.HasValue), Is.EqualTo(new[] { false, true, true }));
            Assert.That(latencies[2], Is.EqualTo(59).Within(0.01));
        }

        // The gateway sends the newest sample of a joint at rest only once.
        [Test]
        public void Fill_OnlySampleOfAJointAtRestArrivesBeforeTheClockIsKnown_IsAssumedAtRest()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            simulated.Session.Listener.Received(
                new JointStateMessage(ControlNow(simulated) - Lengths.Seconds(100), new[] { "shoulder", "elbow" }, new[] { 0.5, 0.25 }), default);
            simulated.Run(5);

            Report(simulated, new[] { "shoulder", "elbow" }.Select(joint => new JointReport(joint, JointDataState.Rest, default, "")).ToArray());
            simulated.Run(0.1);

            Assert.That(StatisticsOf(simulated).JointStatuses.Select(joint => (joint.Joint, joint.State)), Is.EqualTo(
                new[] { ("shoulder", JointDataState.Rest), ("elbow", JointDataState.Rest) }));
            Assert.That(StatisticsOf(simulated).Pose, Is.EqualTo(PoseState.Held));
            Assert.That(MessageOf(simulated).Level, Is.EqualTo(1));
        }
    }
}
