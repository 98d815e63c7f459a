using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.WatchedSession;

namespace Nowpose.Tests.Core.Session
{
    public class JointWatchTests
    {
        static List<PoseState> StatesOf(SimulatedSession simulated, double seconds)
        {
            var states = new List<PoseState>();
            simulated.Run(seconds, (frame, light) => states.Add(frame.State));
            return states;
        }

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
            simulated.Session.Fill(statistics, HeadsetTime.FromSeconds(simulated.Now));

            Assert.That(states.Last(), Is.EqualTo(PoseState.Held));
            Assert.That(after, Is.Not.Empty.And.All.EqualTo(PoseState.Held));
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

            Assert.That(StatesOf(simulated, 1), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
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

            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Held));
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

            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
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

            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Held));
            Assert.That(during.State, Is.EqualTo(JointDataState.Rest));
            Assert.That(during.IsMissing, Is.False);
            Assert.That(DiagnosticsOf(simulated)["missing_joints"], Is.EqualTo("elbow"), "2.6 s after the last report");
            Assert.That(after.State, Is.EqualTo(JointDataState.Stale));
        }

        [Test]
        public void Tick_GatewayReportsRestOfAJointNeverReceived_PoseIsHeldAndTheJointIsMissing()
        {
            var simulated = Running();

            Report(simulated, "grip", JointDataState.Rest, 12);

            Assert.That(StatesOf(simulated, 0.5), Is.Not.Empty.And.All.EqualTo(PoseState.Held), "the position of the gripper is not known");
            Assert.That(StatisticsOf(simulated).JointStatuses.Single().State, Is.EqualTo(JointDataState.Missing));
            Assert.That(DiagnosticsOf(simulated)["missing_joints"], Is.EqualTo("grip"));
        }

        // The gateway sends the newest sample of a joint at rest to a new subscriber, with the time at which it was taken.
        [Test]
        public void Tick_FirstSampleOfAJointAtRestIsAnHourOld_ShowsItsPositionAsCurrent()
        {
            var simulated = Running();
            var latency = StatisticsOf(simulated).ApplicationLatency95;
            var grip = TestRobot.Model.IndexOfMovingJoint("grip");
            Report(simulated, "grip", JointDataState.Rest, 3600);

            simulated.Session.Listener.Received(
                new JointStateMessage(ControlNow(simulated) - TimeSpan.FromHours(1), new[] { "grip" }, new[] { 0.03 }), HeadsetTime.FromSeconds(simulated.Now));
            var positions = new List<double>();
            simulated.Run(0.5, (frame, light) => positions.Add(frame.Joints[grip]));

            Assert.That(positions, Is.Not.Empty.And.All.EqualTo(0.03));
            Assert.That(StatesOf(simulated, 0.5), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses.Single().Description, Is.EqualTo("assumed at rest for 60 min"));
            Assert.That(StatisticsOf(simulated).ApplicationLatency95.Value.TotalMilliseconds, Is.EqualTo(latency.Value.TotalMilliseconds).Within(20));
        }

        // Of a robot whose joints are all at rest, no other sample arrives.
        [Test]
        public void Statistics_OnlySamplesFromBeforeTheSubscription_HaveNoApplicationLatency()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            simulated.Run(5);

            simulated.Session.Listener.Received(
                new JointStateMessage(ControlNow(simulated) - TimeSpan.FromHours(1), new[] { "shoulder", "elbow" }, new[] { 0.5, 0.25 }),
                HeadsetTime.FromSeconds(simulated.Now));
            simulated.Run(0.5);

            Assert.That(StatisticsOf(simulated).Samples, Is.EqualTo(1));
            Assert.That(StatisticsOf(simulated).ApplicationLatency, Is.Null);
        }

        [Test]
        public void Tick_ReportOfTheGatewayEnds_IsCurrentImmediately()
        {
            var simulated = Running();
            Report(simulated, "elbow", JointDataState.Fault);
            simulated.Run(1);

            Report(simulated);

            Assert.That(StatesOf(simulated, 0.5), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
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

            Assert.That(until5, Is.Not.Empty.And.All.EqualTo(PoseState.Held));
            Assert.That(after, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses, Is.Empty);
        }

        // The joint has moved and stopped while this session was not connected.
        [Test]
        public void SampleTaken_SampleFromBeforeTheConnection_HasNoLatency()
        {
            var simulated = Running();
            var latencies = new List<TimeSpan?>();
            simulated.Session.Robots[0].Intake.SampleTaken += (arrival, latency) =>
            {
                if (arrival.Message.Names.Length == 1) latencies.Add(latency);
            };
            void Receive(double age) => simulated.Session.Listener.Received(
                new JointStateMessage(ControlNow(simulated) - Lengths.Seconds(age), new[] { "grip" }, new[] { 0.03 }), HeadsetTime.FromSeconds(simulated.Now));

            Receive(0.05);
            simulated.Run(60);
            simulated.Session.Listener.Connected(HeadsetTime.FromSeconds(simulated.Now));
            Receive(30);
            simulated.Run(1);

            Assert.That(latencies.Select(latency => latency.HasValue), Is.EqualTo(new[] { true, false }));
        }

        // The frame thread describes a frame while the socket's thread reports the faults of the cell.
        [Test]
        public void MissingSince_TwoThreads_ReturnsTheSameTime()
        {
            var simulated = Running();
            Report(simulated, "elbow", JointDataState.Fault, 2);
            var (robot, now) = (simulated.Session.Robots[0], HeadsetTime.FromSeconds(simulated.Now));
            var clock = simulated.Session.Clock.ModelAt(now);
            ControlTime? Since() => robot.Joints.MissingSince(now, clock, robot.Frame.DisplayTime);
            var expected = Since();

            var results = new ControlTime?[2][];
            Parallel.For(0, 2, thread => results[thread] = Enumerable.Range(0, 20000).Select(_ => Since()).ToArray());

            Assert.That(results.SelectMany(each => each).Distinct(), Is.EqualTo(new[] { expected }));
        }

        [Test]
        public void Tick_ReportForAnUnknownJoint_IsIgnored()
        {
            var simulated = Running();

            Report(simulated, "rail", JointDataState.Fault);

            Assert.That(StatesOf(simulated, 0.5), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(StatisticsOf(simulated).JointStatuses, Is.Empty);
        }

        [Test]
        public void Tick_GripperReportedInFault_PoseIsHeld()
        {
            var simulated = Running();

            Report(simulated, "grip", JointDataState.Fault);

            Assert.That(StatesOf(simulated, 0.5), Is.Not.Empty.And.All.EqualTo(PoseState.Held));
        }

        [Test]
        public void Tick_GripperReportedStale_IsNamedAndThePoseStaysCurrent()
        {
            var simulated = Running();

            Report(simulated, "grip", JointDataState.Stale);

            Assert.That(StatesOf(simulated, 0.5), Is.Not.Empty.And.All.EqualTo(PoseState.Current),
                "a joint of the gripper without samples does not make the pose stale");
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
    }
}
