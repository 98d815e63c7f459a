using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Tests.Core.Session.Cell;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Compares the estimate of the displayed error with the simulated truth.</summary>
    public class HindcastTests
    {
        const int Seed = 7;
        static readonly ForwardKinematics Kinematics = new ForwardKinematics(TestRobot.Model);
        static readonly int Tool = TestRobot.Model.IndexOfLink(TestRobot.Model.ToolLink.Name);

        static RigidTransform ToolOf(ReadOnlySpan<double> joints)
        {
            var poses = new RigidTransform[TestRobot.Model.Links.Count];
            Kinematics.Compute(joints, poses);
            return poses[Tool];
        }

        // doesElbowFollow: whether the elbow has the position that follows from that of the shoulder, see TestRobot.WithMimicElbow.
        static RigidTransform TrueTool(double seconds, bool doesElbowFollow = false)
        {
            var joints = new double[TestRobot.Model.MovingJoints.Count];
            var (shoulder, elbow) = SimulatedSession.TruthAt(seconds);
            if (doesElbowFollow) elbow = 0.5 * shoulder;
            joints[TestRobot.Model.IndexOfMovingJoint("shoulder")] = shoulder;
            joints[TestRobot.Model.IndexOfMovingJoint("elbow")] = elbow;
            return ToolOf(joints);
        }

        static double SquareMm(in RigidTransform a, in RigidTransform b) =>
            1e6 * (Math.Pow(a.X - b.X, 2) + Math.Pow(a.Y - b.Y, 2) + Math.Pow(a.Z - b.Z, 2));

        static SessionStatistics Statistics(SimulatedSession simulated) =>
            simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

        // Returns the RMS errors of the displayed and of the uncompensated tool against the simulated truth. Counts only frames that the hindcast can
        // score: up to the newest sample, and from the start of the ninth whole second before the newest frame.
        static (double Mm, double HoldMm) TrueErrors(SimulatedSession simulated, double seconds, bool doesElbowFollow = false)
        {
            var squares = new List<(ControlTime At, double Displayed, double Held)>();
            var (first, last) = (default(ControlTime), default(ControlTime));
            simulated.Run(seconds, (frame, light) =>
            {
                var truth = TrueTool(light, doesElbowFollow);
                squares.Add((frame.DisplayTime.Value, SquareMm(frame.ToolPose, truth), SquareMm(ToolOf(frame.HeldJoints), truth)));
                // The hindcast can score a frame only after the sample that ends the sampling interval of this frame.
                last = frame.DisplayTime.Value - frame.Horizon.Value - TimeSpan.FromMilliseconds(50);
                first = ControlTime.FromSeconds(Math.Floor(frame.DisplayTime.Value.SinceEpoch.TotalSeconds) - 9);
            });
            var scoredFrames = squares.Where(s => s.At >= first && s.At <= last).ToList();
            return (Math.Sqrt(scoredFrames.Average(s => s.Displayed)), Math.Sqrt(scoredFrames.Average(s => s.Held)));
        }

        // With RewriteBeforeRender, the first computation of a frame is not displayed.
        [Test]
        public void Statistics_FramesComputedTwice_AreScoredOnce()
        {
            var frames = new int[2];
            foreach (var isTwice in new[] { false, true })
            {
                var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
                simulated.Run(10, (frame, _) =>
                {
                    if (isTwice) simulated.Session.Tick(frame.Start + Lengths.Ms(1), isLast: false);
                });
                frames[isTwice ? 1 : 0] = Statistics(simulated).ToolErrorOfRun.Value.Frames;
            }

            Assert.That(frames[0], Is.GreaterThan(400));
            Assert.That(frames[1], Is.EqualTo(frames[0]));
        }

        // The square of such a position is infinite.
        [TestCase("shoulder")]
        [TestCase("elbow")]
        public void Statistics_OnePositionIsCorrupt_ErrorsStayPlausible(string joint)
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(10);
            var now = HeadsetTime.FromSeconds(simulated.Now);

            simulated.Session.Listener.Received(
                new JointStateMessage(simulated.Link.TrueOffset(now).ToControl(now) - Lengths.Ms(30), new[] { joint }, new[] { 1e300 }), now);
            simulated.Run(2);

            foreach (var each in Statistics(simulated).JointErrors)
            {
                Assert.That(each.Error.Value.Rms, Is.LessThan(1), each.Joint);
                Assert.That(each.Error.Value.HoldRms, Is.LessThan(1), each.Joint);
            }
            Assert.That(Statistics(simulated).ToolErrorOfRun.Value.HoldRms, Is.LessThan(300), "mm");
        }

        [Test]
        public void Statistics_SimulatedSession_EstimateTheTrueError(
            [Values("lan", "wifi")] string network, [Values("linear", "quadratic", "quadratic-h4")] string predictor, [Values] bool apart)
        {
            var simulated = new SimulatedSession(NetworkProfile.Named(network), Seed, predictor) { IsEachJointApart = apart };
            simulated.Run(8);

            AssertEstimates(simulated, TrueErrors(simulated, 20));
        }

        [Test]
        public void Statistics_MimicJointWithOwnSamples_EstimateTheTrueError([Values] bool apart)
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, robot: TestRobot.WithMimicElbow) { IsEachJointApart = apart };
            simulated.Run(8);

            AssertEstimates(simulated, TrueErrors(simulated, 20));
        }

        [Test]
        public void Statistics_OwnSamplesOfAMimicJointEndAndReturn_EstimateTheTrueError()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, robot: TestRobot.WithMimicElbow);
            simulated.Run(8);

            simulated.SilentJoint = "elbow";
            simulated.Run(4);
            AssertEstimates(simulated, TrueErrors(simulated, 20, doesElbowFollow: true));

            simulated.SilentJoint = null;
            simulated.Run(4);
            AssertEstimates(simulated, TrueErrors(simulated, 20));
        }

        static void AssertEstimates(SimulatedSession simulated, (double Mm, double HoldMm) truth)
        {
            var statistics = Statistics(simulated);
            var message = $"{truth.Mm:0.00} of {truth.HoldMm:0.00} mm, seed {Seed}";
            Assert.That(truth.HoldMm, Is.GreaterThan(50), "the uncompensated error is large");
            Assert.That(statistics.HoldErrorMm.Value, Is.EqualTo(truth.HoldMm).Within(1).Percent, message);
            Assert.That(statistics.ErrorMm.Value, Is.EqualTo(truth.Mm).Within(0.03 * truth.Mm), message + "; the clock has an error, too");
            Assert.That(statistics.ErrorReduction.Value, Is.EqualTo(1 - truth.Mm / truth.HoldMm).Within(0.001), message);
        }

        [Test]
        public void Statistics_HoldPredictor_ReductionIsZero()
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed, "hold");
            simulated.Run(20);

            var statistics = Statistics(simulated);

            Assert.That(statistics.ErrorReduction.Value, Is.EqualTo(0).Within(1e-12));
            Assert.That(statistics.ErrorMm.Value, Is.GreaterThan(50));
        }

        [Test]
        public void Statistics_LongGapBetweenSamples_IsNotScored()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(18.1);
            var max = 0.0;
            simulated.IsSamplingByTest = true;
            simulated.Run(2.4, (frame, light) => max = Math.Max(max, SquareMm(ToolOf(frame.HeldJoints), TrueTool(light))));
            simulated.IsSamplingByTest = false;

            simulated.Run(2);

            Assert.That(Math.Sqrt(max), Is.GreaterThan(500), "the joint moves from one end of the sine to the other");
            Assert.That(Statistics(simulated).HoldErrorMm.Value, Is.LessThan(400),
                "with the gap, the value would be 665; only the 0.1 s until the next samples arrive are scored");
        }

        [Test]
        public void Statistics_RobotAtRest_HaveAnErrorOfZeroAndNoReduction()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            for (var i = 0; i < 200; i++)
            {
                var now = HeadsetTime.FromSeconds(simulated.Now);
                simulated.Session.Listener.Received(new JointStateMessage(
                    simulated.Link.TrueOffset(now).ToControl(now), new[] { "shoulder", "elbow" }, new[] { 0.5, 0.5 }), now);
                simulated.Run(0.05);
            }

            var statistics = Statistics(simulated);

            Assert.That(statistics.ErrorMm.Value, Is.EqualTo(0).Within(1e-6));
            Assert.That(statistics.ErrorReduction, Is.Null);
        }

        [Test]
        public void Statistics_JointWithoutNewSamples_HaveNoError()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            for (var i = 0; i < 200; i++)
            {
                var now = HeadsetTime.FromSeconds(simulated.Now);
                var stamp = simulated.Link.TrueOffset(now).ToControl(now);
                simulated.Session.Listener.Received(new JointStateMessage(stamp, new[] { "shoulder" }, new[] { 0.1 * (i % 7) }), now);
                if (i == 3) simulated.Session.Listener.Received(new JointStateMessage(stamp, new[] { "elbow" }, new[] { 0.5 }), now);
                simulated.Run(0.05);
            }

            Assert.That(Statistics(simulated).ErrorMm, Is.Null, "no later sample gives the elbow's position");
        }

        // The source reports the angle of the continuous elbow from −π to π.
        [Test]
        public void Hindcast_ContinuousJointWrapsItsAngle_HasTheErrorsOfTheUnwrappedAngle()
        {
            var (expected, errors) = (ErrorsOfTurningElbow(angle => angle), ErrorsOfTurningElbow(angle => Math.IEEERemainder(angle, 2 * Math.PI)));

            Assert.That(expected.Tool.HoldRms, Is.GreaterThan(0.05), "m");
            foreach (var (error, of) in new[] { (errors.Tool, expected.Tool), (errors.Elbow, expected.Elbow) })
            {
                Assert.That(error.Frames, Is.EqualTo(of.Frames));
                Assert.That(error.Rms, Is.EqualTo(of.Rms).Within(1e-9));
                Assert.That(error.HoldRms, Is.EqualTo(of.HoldRms).Within(1e-9));
                Assert.That(error.TruthUncertainty, Is.EqualTo(of.TruthUncertainty).Within(1e-9));
                Assert.That(error.ClockUncertainty, Is.EqualTo(of.ClockUncertainty).Within(1e-9));
            }
        }

        static (DisplayedError Tool, DisplayedError Elbow) ErrorsOfTurningElbow(Func<double, double> sent)
        {
            var cell = new CellSession();
            cell.Sampling = t => cell.SendJoints(t, 0, sent(1.5 * t + 0.3 * Math.Sin(2 * t)));
            cell.Run(12);
            var hindcast = cell.Session.Robots[0].Hindcast;
            return (hindcast.Tool.Value, hindcast.JointAt(1).Error.Value);
        }

        [Test]
        public void Diagnostics_KnownError_IsInMillimetres()
        {
            var clock = new SetClock();
            var session = new CompensationSession(
                new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)),
                    new PredictionSettings("linear")),
                TestRobot.Model, clock);
            for (var frame = 0; frame < 1200; frame++)
            {
                clock.Now = HeadsetTime.FromSeconds(10 + frame / 60.0);
                var control = new ControlTime(clock.Now.SinceEpoch);
                var taken = control - TimeSpan.FromMilliseconds(60);
                session.Clock.Add(new SyncExchange(clock.Now - TimeSpan.FromMilliseconds(2), control, control, clock.Now), out _);
                session.Listener.Received(
                    new JointStateMessage(taken, new[] { "shoulder", "elbow" }, new[] { Math.Sin(taken.SinceEpoch.TotalSeconds), 0 }), clock.Now);
                session.Tick(clock.Now);
            }

            var values = session.Listener.Diagnostics().Values.ToDictionary(v => v.Key, v => double.TryParse(v.Value, NumberStyles.Float, CultureInfo.InvariantCulture, out var n) ? n : double.NaN);

            // An arm of 1 m, an RMS angular speed of 1/√2 rad/s and a latency of 100 ms result in an error of 71 mm.
            Assert.That(values["error_mm_hold"], Is.EqualTo(71).Within(5));
            Assert.That(values["error_mm"], Is.LessThan(5));
            Assert.That(values["reduction"], Is.EqualTo(1 - values["error_mm"] / values["error_mm_hold"]).Within(0.001).And.GreaterThan(0.9));
            Assert.That(values["error_mm_p95"], Is.InRange(values["error_mm"], 3 * values["error_mm"]));
            Assert.That(values["error_mm_hold_p95"], Is.EqualTo(100).Within(5), "the error at full speed");
            Assert.That(values["reduction_uncertainty"], Is.InRange(1e-6, 0.05));
            // The error bound of the clock times the RMS speed of 1/√2 m/s.
            Assert.That(values["error_mm_clock"], Is.EqualTo(0.71 * values["error_bound_us"] / 1000).Within(10).Percent);
            Assert.That(values["error_hold/shoulder"], Is.EqualTo(0.071).Within(0.005), "rad");
            Assert.That(values["reduction/shoulder"], Is.EqualTo(values["reduction"]).Within(0.01), "only the shoulder moves");
            Assert.That(values.ContainsKey("reduction/elbow"), Is.False, "a joint at rest has no error to reduce");
        }
    }
}
