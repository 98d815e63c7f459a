using System;
using System.Collections.Generic;
using System.Linq;
using MathNet.Numerics.Statistics;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests which received samples a session uses, and how it counts the dropped samples.</summary>
    public class ReceivedSamplesTests
    {
        const int Seed = 7;
        static readonly int Shoulder = TestRobot.Model.IndexOfMovingJoint("shoulder");

        [Test]
        public void Received_StampFarInTheFuture_IsDroppedAndLaterSamplesAreUsed()
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
        public void Received_DuplicateLateAndForeignSamples_AreCountedByReason()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            foreach (var at in new[] { 1.0, 1.1, 1.2, 1.3, 1.3, 1.3, 0.5, 1.4 }) Send(session, at, at);
            session.Listener.Received(new JointStateMessage(ControlTime.FromSeconds(2), new[] { "other_robot" }, new[] { 1.0 }), default);

            session.Tick(HeadsetTime.FromSeconds(1));

            Assert.That(session.Drops[DropReason.DuplicateSample], Is.EqualTo(2));
            Assert.That(session.Drops[DropReason.LateSample], Is.EqualTo(1), "too old to be used");
            Assert.That(session.Drops[DropReason.UnknownJoint], Is.EqualTo(1));
            Assert.That(session.Statistics(default).Samples, Is.EqualTo(5), "1.0 to 1.4");
        }

        // The positions of the moving joint contradict the earlier ones; those of the joint at rest do not.
        [Test]
        public void Add_ClockWentBack_RestartsAllJointsOfTheMessage(
            [Values(0.13, 0.2, 0.23)] double back, [Values("shoulder", "elbow")] string moving)
        {
            var tracks = new JointTracks(TestRobot.Model, PredictionSettings.Default);
            var names = new[] { "shoulder", "elbow" };
            var joints = names.Select(TestRobot.Model.IndexOfMovingJoint).ToArray();
            void Add(double time, double stamp) => tracks.Add(new JointStateMessage(
                ControlTime.FromSeconds(100 + stamp), names, names.Select(name => name == moving ? Math.Sin(3 * time) : 0.5).ToArray()), joints);
            for (var k = 0; k < 60; k++) Add(0.05 * k, 0.05 * k);

            for (var k = 60; k < 63; k++) Add(0.05 * k, 0.05 * k - back);

            var newest = ControlTime.FromSeconds(100 + 3.1 - back);
            foreach (var joint in joints) Assert.That((tracks.NewestOf(joint) - newest).Value.TotalMilliseconds, Is.Zero.Within(0.01));
        }

        // With RewriteBeforeRender, the first computation of a frame is not displayed, and a recording does not contain it.
        [Test]
        public void Add_AfterAnotherComputation_BlendsFromTheDisplayedPositions([Values] bool isDisplayed)
        {
            double ShoulderAfter(bool isComputedTwice)
            {
                var tracks = new JointTracks(TestRobot.Model, new PredictionSettings("linear", blendMs: 100));
                for (var k = 0; k < 40; k++)
                {
                    var time = ControlTime.FromSeconds(100 + 0.05 * k);
                    tracks.Add(new JointStateMessage(time, new[] { "shoulder" }, new[] { Math.Sin(0.1 * k) }), new[] { Shoulder });
                    tracks.Predict(time + Lengths.Ms(100));
                    if (isComputedTwice) tracks.Predict(time + Lengths.Ms(108), isDisplayed);
                }
                tracks.Predict(ControlTime.FromSeconds(102.06));
                return tracks.Positions[Shoulder];
            }

            var difference = Math.Abs(ShoulderAfter(isComputedTwice: true) - ShoulderAfter(isComputedTwice: false));

            Assert.That(difference, isDisplayed ? Is.GreaterThan(1e-6) : Is.Zero);
        }

        [Test]
        public void Received_UnusedLateSample_DoesNotAffectTheNextSample()
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
            Assert.That(frame.Horizon.Value, Is.EqualTo(TimeSpan.FromMilliseconds(40)).Within(TimeSpan.FromMilliseconds(1)),
                "the value equals the display latency");
        }

        [Test]
        public void Received_StampsCoarserThanTheSamplingInterval_PoseStaysCurrent()
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

            Assert.That(states.Skip(10), Is.Not.Empty.And.All.EqualTo(PoseState.Current),
                "the pose is current although three of four samples repeat a stamp");
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

            Assert.That(shown, Is.EqualTo(3).Within(1e-9), "0.3 rad below the received position");
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
            Assert.That(At(0.15, 0.05, 0), Is.EqualTo(At(0.15, 0.1, 0.05, 0)).Within(1e-4), "both sequences lie on the same parabola");
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
            Assert.That(frame.Joints[TestRobot.Model.IndexOfMovingJoint("grip")], Is.EqualTo(0.02), "the only sample of this joint");
            Assert.That(session.Statistics(default).Samples, Is.EqualTo(21));
            Assert.That(session.Drops[DropReason.SlowReader], Is.EqualTo(979));
            Assert.That(judged, Has.Count.EqualTo(1000));
            Assert.That(judged.Select(j => j.Stamp), Is.Ordered, "in the order of arrival");
            Assert.That(judged.Skip(980).Select(j => j.Reason), Is.Not.Empty.And.All.EqualTo(DropReason.None));
        }

        // A gripper that sends its position only when it changes, while a source at 1 kHz sends the arm's joints.
        [Test]
        public void Tick_OtherSourceFillsTheQueue_NewestSampleOfEachSourceIsUsed()
        {
            var session = new SimulatedSession(NetworkProfile.Lan, Seed).Session;
            void SendGrip(double at, double position) => session.Listener.Received(
                new JointStateMessage(ControlTime.FromSeconds(at), new[] { "grip" }, new[] { position }), default);
            SendGrip(0.98, 0.01);
            SendGrip(0.99, 0.02);
            for (var i = 0; i < 3000; i++) Send(session, 1 + i * 0.001, i * 0.0001);

            var frame = session.Tick(HeadsetTime.FromSeconds(20));

            Assert.That(frame.Joints[TestRobot.Model.IndexOfMovingJoint("grip")], Is.EqualTo(0.02));
            Assert.That(frame.Joints[Shoulder], Is.EqualTo(0.2999));
            Assert.That((session.Statistics(default).Samples, session.Drops[DropReason.SlowReader]), Is.EqualTo((21L, 2981L)));
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

            Assert.That(session.Drops[DropReason.LateSample], Is.EqualTo(2),
                "a quadratic uses the three newest samples; a message with two joints counts once");
        }

        static void Send(CompensationSession session, double controlSeconds, double shoulder) => session.Listener.Received(
            new JointStateMessage(ControlTime.FromSeconds(controlSeconds), new[] { "shoulder", "elbow" }, new[] { shoulder, 0 }), default);
    }
}
