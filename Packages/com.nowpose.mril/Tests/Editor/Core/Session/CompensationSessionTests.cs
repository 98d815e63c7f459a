using System;
using System.Collections.Generic;
using System.Linq;
using MathNet.Numerics.Statistics;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests the displayed pose in whole sessions with a simulated robot.</summary>
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

            Assert.That(1 - Rms(errors) / Rms(holdErrors), Is.GreaterThan(0.9), "a slow sine is nearly a parabola; seed " + Seed);
            Assert.That(Rms(holdErrors), Is.GreaterThan(0.05), "the uncompensated error is large");
            Assert.That(lightErrorsMs.Max(Math.Abs), Is.LessThan(1), "seed " + Seed);
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
            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
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
            simulated.Run(2, (frame, light) =>
                Assert.That(Math.Abs(frame.Joints[Shoulder]), Is.LessThan(1.5), "the joint stays near its range of motion"));

            var errors = new List<double>();
            var states = new List<PoseState>();
            simulated.Run(5, (frame, light) => errors.Add(frame.Joints[Shoulder] - SimulatedSession.TruthAt(light).Shoulder));
            simulated.Run(1, (frame, light) => states.Add(frame.State));
            Assert.That(Rms(errors), Is.LessThan(0.01));
            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(simulated.Session.Clock.Steps, Is.EqualTo(1));
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
        public void Tick_MimicJoint_HasTheKindOfTheJointItFollows()
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

            Assert.That(soon, Is.EqualTo(PoseState.Current), "ten seconds without exchanges add little error");
            Assert.That(late, Is.EqualTo(PoseState.Unsynchronised));
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
                Assert.That(frame.State, Is.EqualTo(PoseState.Current), "missing samples of the gripper do not affect the arm");
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

            Assert.That(frame.Joints[Shoulder], Is.EqualTo(3).Within(1e-12), "an unclamped prediction would be 0.18 rad beyond the limit");
        }

        static void Send(CompensationSession session, double controlSeconds, double shoulder) => session.Listener.Received(
            new JointStateMessage(ControlTime.FromSeconds(controlSeconds), new[] { "shoulder", "elbow" }, new[] { shoulder, 0 }), default);
    }
}
