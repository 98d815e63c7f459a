using System;
using System.Collections.Generic;
using System.Linq;
using MathNet.Numerics.Statistics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class CompensationSessionTests
    {
        const int Seed = 7;
        static readonly int Shoulder = TestRobot.Model.IndexOfMovingJoint("shoulder");
        static readonly int Elbow = TestRobot.Model.IndexOfMovingJoint("elbow");

        static double Rms(IEnumerable<double> values) => Math.Sqrt(values.Average(v => v * v));

        [TestCase("lan")]
        [TestCase("wifi")]
        public void Tick_WholeSession_ShowsTheRobotAtItsTruePose(string network)
        {
            var simulated = new SimulatedSession(NetworkProfile.Named(network), Seed);
            simulated.Run(6);
            var errors = new List<double>();
            var holdErrors = new List<double>();
            var lightErrorsMs = new List<double>();

            simulated.Run(30, (frame, light) =>
            {
                var truth = SimulatedSession.TruthAt(light);
                errors.Add(frame.Joints[Shoulder] - truth.Shoulder);
                errors.Add(frame.Joints[Elbow] - truth.Elbow);
                holdErrors.Add(frame.HeldJoints[Shoulder] - truth.Shoulder);
                holdErrors.Add(frame.HeldJoints[Elbow] - truth.Elbow);
                var trueLight = HeadsetTime.FromSeconds(light);
                lightErrorsMs.Add((frame.DisplayTime.Value - simulated.Link.TrueOffset(trueLight).ToControl(trueLight)).TotalMilliseconds);
                Assert.That(frame.State, Is.EqualTo(PoseState.Current), "at " + light + " s, seed " + Seed);
            });

            Assert.That(1 - Rms(errors) / Rms(holdErrors), Is.GreaterThan(0.9), "a sine this slow is nearly a parabola; seed " + Seed);
            Assert.That(Rms(holdErrors), Is.GreaterThan(0.05), "the effect is there to be removed");
            Assert.That(lightErrorsMs.Max(Math.Abs), Is.LessThan(1), "seed " + Seed);
        }

        [Test]
        public void Statistics_WholeSession_MeasureTheSimulatedLatency()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(20);
            var arrived = simulated.TrueLatenciesMs.Take((int)simulated.Session.Statistics(default).Samples).ToList();
            var recent = arrived.Skip(arrived.Count - 200).ToArray();

            var statistics = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

            Assert.That(statistics.Clock.State, Is.EqualTo(ClockState.Synchronised));
            Assert.That(statistics.ApplicationLatency.Value.TotalMilliseconds, Is.EqualTo(recent.Quantile(0.5)).Within(0.2));
            Assert.That(statistics.ApplicationLatency95.Value.TotalMilliseconds, Is.EqualTo(recent.Quantile(0.95)).Within(0.5));
            Assert.That(statistics.NegativeLatencies, Is.EqualTo(0));
            Assert.That(statistics.Samples, Is.EqualTo(20 / 0.05).Within(5));
            Assert.That(statistics.Dropped, Is.EqualTo(0));
            Assert.That(statistics.VisualisationLatency, Is.EqualTo(TimeSpan.FromMilliseconds(40)));
        }

        [Test]
        public void Fill_UsedStatistics_ReplacesAllValues()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(10);
            var statistics = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));
            var known = statistics.ApplicationLatency;

            new SimulatedSession(NetworkProfile.Lan, Seed).Session.Fill(statistics, default);

            var fresh = new SessionStatistics();
            Assert.That(known, Is.Not.Null);
            var others = new[] { "VisualisationLatency", "RangeUnknownReason", "JointErrors", "JointStatuses" };
            foreach (var property in typeof(SessionStatistics).GetProperties().Where(p => !others.Contains(p.Name)))
                Assert.That(property.GetValue(statistics), Is.EqualTo(property.GetValue(fresh)), property.Name);
            Assert.That(statistics.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.NoLimit));
            Assert.That(statistics.JointErrors.Select(j => j.Error), Is.All.Null);
            Assert.That(statistics.JointStatuses.Select(j => j.Age), Is.All.Null);
        }

        [Test]
        public void Diagnostics_BeforeAndAfterTheClockIsKnown_OmitUnknownValues()
        {
            var clock = new SetClock();
            var session = new CompensationSession(
                new SessionSettings(
                    new ConnectionSettings("127.0.0.1", headsetName: "left"), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
                TestRobot.Model, clock);
            var before = session.Listener.Diagnostics();
            session.Clock.Add(new SyncExchange(
                HeadsetTime.FromSeconds(1), ControlTime.FromSeconds(101.001),
                ControlTime.FromSeconds(101.001), HeadsetTime.FromSeconds(1.002)), out _);
            clock.Now = HeadsetTime.FromSeconds(1.002);

            var after = session.Listener.Diagnostics();

            Assert.That(before.HardwareId, Is.EqualTo("left"));
            Assert.That(before.Values.Select(v => v.Key), Is.EqualTo(new[]
            {
                "state", "pose", "missing_joints", "joint_status/shoulder", "joint_status/elbow", "l_visu_ms", "samples", "dropped",
            }));
            Assert.That(before.Values[0].Value, Is.EqualTo("unsynchronised"));
            Assert.That(before.Level, Is.EqualTo(2));
            Assert.That(before.Message, Does.EndWith("missing joints: shoulder,elbow"));
            Assert.That(after.Stamp, Is.EqualTo(ControlTime.FromSeconds(101.002)));
            var values = after.Values.ToDictionary(v => v.Key, v => v.Value);
            Assert.That(values["state"], Is.EqualTo("converging"));
            Assert.That(values["offset_ns"], Is.EqualTo("-100000000000"));
            Assert.That(values["rtt_ms"], Is.EqualTo("2"));
            Assert.That(values["error_bound_us"], Is.EqualTo("1001.4"), "half the round trip, and 700 ppm of it for the skew");
            Assert.That(values["l_visu_ms"], Is.EqualTo("40"));
            Assert.That(values.Keys, Has.No.Member("l_app_ms"), "no sample yet");
        }

        [Test]
        public void Tick_WithoutSamples_IsIncomplete()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;

            var frame = session.Tick(HeadsetTime.FromSeconds(0));

            Assert.That(frame.State, Is.EqualTo(PoseState.Incomplete));
            Assert.That(frame.DisplayTime, Is.Null);
            Assert.That(frame.ToolPose.X, Is.EqualTo(1).Within(1e-12), "the robot's zero pose");
        }

        [Test]
        public void Tick_WithoutClock_HoldsTheNewestSampleAsUnsynchronised()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            Send(session, 100, 0.25);
            Send(session, 100.05, 0.5);

            var frame = session.Tick(HeadsetTime.FromSeconds(1));

            Assert.That(frame.State, Is.EqualTo(PoseState.Unsynchronised));
            Assert.That(frame.Joints[Shoulder], Is.EqualTo(0.5));
            Assert.That(frame.Kinds[Shoulder], Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void Tick_GatewayDown_HoldsThePoseUntilItReturns()
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed);
            simulated.Run(10);
            simulated.IsGatewayUp = false;
            simulated.Run(1);
            var shown = new List<double>();

            simulated.Run(3, (frame, light) =>
            {
                shown.Add(frame.Joints[Shoulder]);
                Assert.That(frame.State, Is.EqualTo(PoseState.Held));
            });
            simulated.IsGatewayUp = true;
            simulated.Run(1);
            var states = new List<PoseState>();
            simulated.Run(1, (frame, light) => states.Add(frame.State));

            Assert.That(shown.Max() - shown.Min(), Is.EqualTo(0), "a held pose does not move");
            Assert.That(states, Is.All.EqualTo(PoseState.Current));
        }

        [TestCase(3600)]
        [TestCase(-3600)]
        [TestCase(0.2)]
        [TestCase(-0.2)]
        [TestCase(-0.1)]
        public void Tick_ControlClockSteps_FollowsAfterTwoSecondsAndIsCurrentAfterSeven(double stepSeconds)
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed);
            simulated.Run(10);

            simulated.Link.Step = Lengths.Seconds(stepSeconds);
            simulated.Run(2, (frame, light) => Assert.That(Math.Abs(frame.Joints[Shoulder]), Is.LessThan(1.5), "nothing flies off"));

            var errors = new List<double>();
            var states = new List<PoseState>();
            simulated.Run(5, (frame, light) => errors.Add(frame.Joints[Shoulder] - SimulatedSession.TruthAt(light).Shoulder));
            simulated.Run(1, (frame, light) => states.Add(frame.State));
            Assert.That(Rms(errors), Is.LessThan(0.01));
            Assert.That(states, Is.All.EqualTo(PoseState.Current));
            Assert.That(simulated.Session.Clock.Steps, Is.EqualTo(1));
        }

        [Test]
        public void Received_StampFarInTheFuture_IsDroppedAndDoesNotStopTheRest()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(10);
            var now = HeadsetTime.FromSeconds(simulated.Now);
            var future = simulated.Link.TrueOffset(now).ToControl(now) + TimeSpan.FromSeconds(30);

            simulated.Session.Listener.Received(new JointStateMessage(future, new[] { "shoulder" }, new[] { 2.9 }), now);
            simulated.Run(1, (frame, light) =>
                Assert.That(frame.Joints[Shoulder], Is.EqualTo(SimulatedSession.TruthAt(light).Shoulder).Within(0.05)));

            Assert.That(simulated.Session.Drops[DropReason.StampInFuture], Is.EqualTo(1));
        }

        [Test]
        public void Received_DuplicatesLateAndForeignSamples_AreCountedByReason()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            foreach (var at in new[] { 1.0, 1.1, 1.2, 1.3, 1.3, 1.3, 0.5, 1.4 }) Send(session, at, at);
            session.Listener.Received(new JointStateMessage(ControlTime.FromSeconds(2), new[] { "other_robot" }, new[] { 1.0 }), default);

            session.Tick(HeadsetTime.FromSeconds(1));

            Assert.That(session.Drops[DropReason.DuplicateSample], Is.EqualTo(2));
            Assert.That(session.Drops[DropReason.LateSample], Is.EqualTo(1), "too old to be of use");
            Assert.That(session.Drops[DropReason.UnknownJoint], Is.EqualTo(1));
            Assert.That(session.Statistics(default).Samples, Is.EqualTo(5), "1.0 to 1.4");
        }

        [Test]
        public void Received_LateSampleWithoutUse_DoesNotAffectTheNext()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(6);
            var taken = new List<ControlTime>();
            simulated.Session.Intake.SampleTaken += (arrival, latency) => taken.Add(arrival.Message.Stamp);
            var now = HeadsetTime.FromSeconds(simulated.Now);
            var stamp = simulated.Link.TrueOffset(now).ToControl(now);
            foreach (var each in new[] { stamp - TimeSpan.FromSeconds(20), stamp })
                simulated.Session.Listener.Received(new JointStateMessage(each, new[] { "shoulder", "elbow" }, new[] { 0.1, 0.1 }), now);

            var frame = simulated.Session.Tick(now);

            Assert.That(taken.Last(), Is.EqualTo(stamp));
            Assert.That(frame.Horizon.Value, Is.EqualTo(TimeSpan.FromMilliseconds(40)).Within(TimeSpan.FromMilliseconds(1)), "the display latency");
        }

        [Test]
        public void Tick_ArmPublishedInTwoHalves_IsIncompleteUntilBothArrive()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            var now = HeadsetTime.FromSeconds(0.5);
            simulated.Session.Listener.Received(new JointStateMessage(ControlTime.FromSeconds(1), new[] { "shoulder" }, new[] { 0.5 }), now);
            var half = simulated.Session.Tick(now).State;
            simulated.Session.Listener.Received(new JointStateMessage(ControlTime.FromSeconds(1), new[] { "elbow" }, new[] { 0.5 }), now);

            var whole = simulated.Session.Tick(now).State;

            Assert.That(half, Is.EqualTo(PoseState.Incomplete));
            Assert.That(whole, Is.Not.EqualTo(PoseState.Incomplete));
        }

        [Test]
        public void Tick_MimicJoint_HasTheKindOfItsMaster()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            var (grip, follower) = (TestRobot.Model.IndexOfMovingJoint("grip"), TestRobot.Model.IndexOfMovingJoint("grip_mirror"));
            var before = session.Tick(default).Kinds[follower];
            session.Listener.Received(new JointStateMessage(ControlTime.FromSeconds(1), new[] { "grip" }, new[] { 0.02 }), default);

            var frame = session.Tick(default);

            Assert.That(before, Is.EqualTo(PredictionKind.None));
            Assert.That(frame.Kinds[follower], Is.EqualTo(frame.Kinds[grip]).And.EqualTo(PredictionKind.Held));
            Assert.That(frame.Joints[follower], Is.EqualTo(-0.02));
        }

        [Test]
        public void Tick_LongHoldover_IsNotCurrentDespiteSamples()
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed);
            simulated.Run(10);
            simulated.IsSyncUp = false;
            var soon = PoseState.Incomplete;
            simulated.Run(10, (frame, light) => soon = frame.State);

            var late = PoseState.Incomplete;
            simulated.Run(600, (frame, light) => late = frame.State);

            Assert.That(soon, Is.EqualTo(PoseState.Current), "ten seconds cost little");
            Assert.That(late, Is.EqualTo(PoseState.Unsynchronised));
        }

        [Test]
        public void Received_StampsCoarserThanTheSamples_StayCurrent()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(6);
            var states = new List<PoseState>();
            simulated.IsSamplingByTest = true;
            for (var ms = 0; ms < 2000; ms++)
            {
                var now = HeadsetTime.FromSeconds(simulated.Now);
                var (shoulder, elbow) = SimulatedSession.TruthAt(simulated.Now);
                var coarse = HeadsetTime.FromSeconds(Math.Floor(simulated.Now / 0.004) * 0.004);
                simulated.Session.Listener.Received(
                    new JointStateMessage(
                        simulated.Link.TrueOffset(coarse).ToControl(coarse), new[] { "shoulder", "elbow" }, new[] { shoulder, elbow }), now);
                simulated.Run(0.001, (frame, light) => states.Add(frame.State));
            }

            Assert.That(states.Skip(10), Is.All.EqualTo(PoseState.Current), "three of four samples repeat a stamp");
        }

        [Test]
        public void Received_JointBeyondItsLimits_IsClampedAndReported()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            var shown = 0.0;
            for (var i = 0; i < 40; i++)
            {
                var now = HeadsetTime.FromSeconds(simulated.Now);
                simulated.Session.Listener.Received(
                    new JointStateMessage(simulated.Link.TrueOffset(now).ToControl(now), new[] { "shoulder", "elbow" }, new[] { 3.3, 9 }), now);
                simulated.Run(0.05, (frame, light) => shown = frame.Joints[TestRobot.Model.IndexOfMovingJoint("shoulder")]);
            }

            var beyond = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now)).BeyondLimits;

            Assert.That(shown, Is.EqualTo(3).Within(1e-9), "0.3 rad beside the arm");
            Assert.That(beyond.Joint.Name, Is.EqualTo("shoulder"));
            Assert.That(beyond.Position, Is.EqualTo(3.3));
            Assert.That(simulated.Session.BeyondLimits, Is.EqualTo(new[] { beyond }));
        }

        [Test]
        public void Received_OneSampleOvertaken_IsUsedInOrder()
        {
            double At(params double[] order)
            {
                var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
                simulated.IsGatewayUp = false;
                for (var i = 0; i < 5; i++)
                {
                    simulated.Link.TryExchange(HeadsetTime.FromSeconds(i * 0.2), out var exchange);
                    simulated.Session.Clock.Add(exchange, out _);
                }
                simulated.Session.Tick(HeadsetTime.FromSeconds(1));
                foreach (var age in order)
                {
                    var t = HeadsetTime.FromSeconds(1 - age);
                    simulated.Session.Listener.Received(new JointStateMessage(
                        simulated.Link.TrueOffset(t).ToControl(t), new[] { "shoulder" }, new[] { 4 * age * age }), HeadsetTime.FromSeconds(1));
                }
                return simulated.Session.Tick(HeadsetTime.FromSeconds(1.02)).Joints[Shoulder];
            }

            Assert.That(At(0.15, 0.05, 0.1, 0), Is.EqualTo(At(0.15, 0.1, 0.05, 0)));
            Assert.That(At(0.15, 0.05, 0), Is.EqualTo(At(0.15, 0.1, 0.05, 0)).Within(1e-4), "a parabola either way");
        }

        [Test]
        public void Tick_ArmAndGripperPublishSeparately_ArmDeterminesTheState()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            var now = HeadsetTime.FromSeconds(0);
            simulated.Session.Listener.Received(
                new JointStateMessage(simulated.Link.TrueOffset(now).ToControl(now), new[] { "grip" }, new[] { 0.02 }), now);
            simulated.Run(0.05);
            simulated.Run(10);
            var grip = TestRobot.Model.IndexOfMovingJoint("grip");
            var at = HeadsetTime.FromSeconds(simulated.Now);
            simulated.Session.Listener.Received(
                new JointStateMessage(simulated.Link.TrueOffset(at).ToControl(at), new[] { "grip" }, new[] { 0.03 }), at);

            simulated.Run(2, (frame, light) =>
            {
                Assert.That(frame.State, Is.EqualTo(PoseState.Current), "the gripper's silence is not the arm's");
                Assert.That(frame.Kinds[grip], Is.EqualTo(PredictionKind.Held));
                Assert.That(frame.Joints[grip], Is.EqualTo(0.03));
            });
        }

        [Test]
        public void Tick_JointAtItsLimit_IsNotPredictedBeyondIt()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            var session = simulated.Session;
            for (var i = 0; i < 20; i++)
            {
                var t = HeadsetTime.FromSeconds(i * 0.2);
                simulated.Link.TryExchange(t, out var exchange);
                session.Clock.Add(exchange, out _);
            }
            session.Tick(HeadsetTime.FromSeconds(4));
            foreach (var age in new[] { 0.2, 0.1, 0.0 })
            {
                var t = HeadsetTime.FromSeconds(4 - age);
                session.Listener.Received(new JointStateMessage(
                    simulated.Link.TrueOffset(t).ToControl(t), new[] { "shoulder" }, new[] { 2.99 - 2 * age }), t);
            }

            var frame = session.Tick(HeadsetTime.FromSeconds(4.05));

            Assert.That(frame.Joints[Shoulder], Is.EqualTo(3).Within(1e-12), "0.18 rad past the limit if it were not clamped");
        }

        [Test]
        public void Received_QueueFull_DropsTheOldest()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            for (var i = 0; i < 1100; i++) Send(session, 1 + i * 0.01, i);

            session.Tick(default);

            Assert.That(session.Drops[DropReason.SlowReader], Is.EqualTo(1080));
            Assert.That(session.Statistics(default).Samples, Is.EqualTo(20));
        }

        [Test]
        public void Tick_ThousandQueuedMessages_UsesTheNewestOfEachJointAndCountsTheOthers()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            var judged = new List<(ControlTime Stamp, DropReason Reason)>();
            session.Intake.SampleJudged += (arrival, reason) => judged.Add((arrival.Message.Stamp, reason));
            session.Listener.Received(new JointStateMessage(ControlTime.FromSeconds(1), new[] { "grip" }, new[] { 0.02 }), default);
            for (var i = 1; i < 1000; i++) Send(session, 1 + i * 0.01, i * 0.001);

            var frame = session.Tick(HeadsetTime.FromSeconds(20));

            Assert.That(frame.Joints[Shoulder], Is.EqualTo(0.999));
            Assert.That(frame.Joints[TestRobot.Model.IndexOfMovingJoint("grip")], Is.EqualTo(0.02), "the only one it sent");
            Assert.That(session.Statistics(default).Samples, Is.EqualTo(21));
            Assert.That(session.Drops[DropReason.SlowReader], Is.EqualTo(979));
            Assert.That(judged, Has.Count.EqualTo(1000));
            Assert.That(judged.Select(j => j.Stamp), Is.Ordered, "in the order of arrival");
            Assert.That(judged.Skip(980).Select(j => j.Reason), Is.All.EqualTo(DropReason.None));
        }

        [Test]
        public void Tick_FewQueuedMessages_UsesAll()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            for (var i = 0; i < 30; i++) Send(session, 1 + i * 0.01, i * 0.001);

            session.Tick(default);

            Assert.That(session.Statistics(default).Samples, Is.EqualTo(30));
            Assert.That(session.Drops.Total, Is.EqualTo(0));
        }

        [Test]
        public void Received_ConsecutiveOvertakenSamples_AreAllUsed()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            foreach (var at in new[] { 1.0, 1.02, 1.04, 1.06, 1.14, 1.08, 1.1, 1.12, 1.16 }) Send(session, at, at);

            session.Tick(HeadsetTime.FromSeconds(1));

            Assert.That(session.Drops.Total, Is.EqualTo(0));
            Assert.That(session.Statistics(default).Samples, Is.EqualTo(9));
        }

        [Test]
        public void Received_UnusableSamplesInARow_AreCountedPerMessage()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            foreach (var at in new[] { 1.0, 1.04, 1.08, 1.12, 1.16, 1.06, 1.02, 1.2 }) Send(session, at, at);

            session.Tick(HeadsetTime.FromSeconds(1));

            Assert.That(session.Drops[DropReason.LateSample], Is.EqualTo(2), "a quadratic looks back over three; two joints each");
        }

        [TestCase("", "host: ''")]
        [TestCase("not a host", "host: 'not a host'")]
        [TestCase("192.168.0.5", "is not this machine")]
        public void ConnectionSettings_InvalidHost_ThrowsWithTheValue(string host, string named)
        {
            var error = Assert.Throws<InputException>(() => new ConnectionSettings(host));

            Assert.That(error.Message, Does.Contain(named));
        }

        [Test]
        public void ConnectionSettings_TokenInPlainTextBeyondLoopback_IsRefusedEvenOnATrustedLan()
        {
            var error = Assert.Throws<InputException>(() => new ConnectionSettings("192.168.0.5", token: "secret", insecureLan: true));

            Assert.That(error.Message, Does.Contain("unencrypted").And.Not.Contain("secret"));
        }

        [Test]
        public void Settings_OutOfRange_ThrowWithValueUnitAndRange()
        {
            Assert.That(Assert.Throws<InputException>(() => new PredictionSettings(horizonCapMs: -1)).Message,
                Is.EqualTo("horizon cap: -1 ms is out of range; allowed are 0 to 5000 ms"));
            Assert.That(Assert.Throws<InputException>(() => new SessionSettings(
                    new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.Zero), syncIntervalMs: 5)).Message,
                Is.EqualTo("sync interval: 5 ms is out of range; allowed are 20 to 10000 ms"));
        }

        static void Send(CompensationSession session, double controlSeconds, double shoulder) => session.Listener.Received(
            new JointStateMessage(ControlTime.FromSeconds(controlSeconds), new[] { "shoulder", "elbow" }, new[] { shoulder, 0 }), default);
    }
}
