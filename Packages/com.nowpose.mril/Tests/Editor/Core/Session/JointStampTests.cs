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
    /// <summary>Tests joints whose source has another clock, or whose only sample is from before a restart of the clock.</summary>
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
            var second = simulated.Session.Robots.Add("arm2", TestRobot.Model);
            for (var i = 0; i < 60; i++)
            {
                second.Intake.Add(
                    new JointStateMessage(ControlNow(simulated) + Lengths.Ms(150), new[] { "shoulder", "elbow" }, new[] { 0.01 * i, 0.01 * i }),
                    HeadsetTime.FromSeconds(simulated.Now));
                simulated.Run(0.05);
            }

            Assert.That(StatisticsOf(simulated).WorstPose, Is.EqualTo(PoseState.Current));
            Assert.That(MessageOf(simulated).Message, Is.EqualTo(RobotMessages.OfRobot("arm2", RobotMessages.StampsAhead)));
        }

        [Test]
        public void Horizon_GripperStampsAhead_IsThatOfTheArm()
        {
            var simulated = Running(0);

            Receive(simulated, "grip", age: -0.9);
            simulated.Run(0.1);

            Assert.That(StatisticsOf(simulated).Horizon.Value.TotalSeconds, Is.InRange(0.05, 0.25));
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
