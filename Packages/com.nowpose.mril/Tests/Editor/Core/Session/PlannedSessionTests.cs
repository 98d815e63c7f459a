using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using Nowpose.Sync;
using Nowpose.Tests.Core.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Tests a session whose control system publishes its set-points in advance.</summary>
    public class PlannedSessionTests
    {
        static double Rms(IEnumerable<double> values) => Math.Sqrt(values.Average(v => v * v));

        static double Ratio(VirtualCellRun run) => Rms(run.Errors) / Rms(run.HoldErrors);

        static VirtualCellRun Run(double? lagMs, int seed, string network = "wifi")
        {
            var run = new VirtualCellRun(new VirtualCellSettings(50, 55, 105, 0, 0, NetworkProfile.Named(network)), seed);
            if (lagMs.HasValue) run.Cell.PlanLag = Lengths.Ms(lagMs.Value);
            run.Run(15);
            return run.Run(25);
        }

        [TestCase(0, 1)]
        [TestCase(40, 2, Category = "Study")]
        [TestCase(150, 1, Category = "Study")]
        public void Tick_PlanPublished_ReducesTheErrorToAFraction(double lagMs, int seed)
        {
            var predicted = Ratio(Run(null, seed));

            var run = Run(lagMs, seed);

            Assert.That(run.Errors, Has.Count.EqualTo(run.Frames), "all frames are current");
            // The remaining error comes from the clock and from the estimated lag.
            Assert.That(Ratio(run), Is.LessThan(0.2 * predicted).And.LessThan(0.02), $"lag {lagMs} ms, seed {seed}");
            Assert.That(run.Session.Tick(run.Now).Kinds.ToArray(), Has.Some.EqualTo(PredictionKind.Planned));
        }

        [Test]
        public void Tick_PlanDoesNotMatchTheMotion_IsIgnored()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings(), 3);
            run.Run(15);
            // The robot's motion differs from the plan by a delay of 1.5 s.
            run.Cell.PlanLag = Lengths.Seconds(1.5);
            run.Run(5);

            run.Run(25);

            Assert.That(Ratio(run), Is.LessThan(0.0135), "seed 3");
        }

        [Test]
        public void Tick_PlanEnds_ContinuesWithoutAJump()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings(), 4);
            run.Cell.PlanLag = TimeSpan.Zero;
            run.Run(20.3);
            var before = Rms(run.HoldErrors);

            run.Cell.PlanLag = null;
            var positions = new List<(double[] Shown, double[] True)>();
            for (var i = 0; i < 150; i++)
            {
                run.Run(1 / 60.0);
                var truth = new double[run.Session.Robot.MovingJoints.Count];
                run.Cell.TruthAt(run.Now - TimeSpan.FromTicks(TimeSpan.TicksPerSecond / 60) + TimeSpan.FromMilliseconds(40), truth);
                positions.Add((run.Session.Tick(run.Now - TimeSpan.FromTicks(TimeSpan.TicksPerSecond / 60)).Joints.ToArray(), truth));
            }

            var jumps = positions.Zip(positions.Skip(1), (a, b) =>
                Enumerable.Range(0, a.Shown.Length).Max(j => Math.Abs(b.Shown[j] - a.Shown[j] - (b.True[j] - a.True[j]))));
            Assert.That(before, Is.GreaterThan(0.01), "the robot moves");
            Assert.That(jumps.Max(), Is.LessThan(0.05), "rad, seed 4");
        }

        // Both clocks show the same time. The plan swings the arm from one side to the other within two seconds, but the arm stops halfway.
        [Test]
        public void Tick_RobotStopsDespiteThePlan_StopsFollowingThePlanAfterTheFirstSamples()
        {
            var session = NewSession();
            var plan = new JointTrajectoryMessage(ControlTime.FromSeconds(12), new[] { "shoulder" }, new[]
            {
                new JointTrajectoryPoint(TimeSpan.Zero, new[] { -1.0 }, new[] { 0.0 }),
                new JointTrajectoryPoint(TimeSpan.FromSeconds(2), new[] { 1.0 }, new[] { 0.0 }),
            });
            double Planned(double t) { var x = Math.Min(Math.Max((t - 12) / 2, 0), 1); return -1 + 2 * x * x * (3 - 2 * x); }
            double Truth(double t) => Planned(Math.Min(t, 13));
            var (kinds, errors) = (new List<(double At, PredictionKind Kind)>(), new List<(double At, double Error)>());

            session.Listener.Planned(plan, HeadsetTime.FromSeconds(11));
            Drive(session, 11, 15, Truth, (at, frame) =>
            {
                kinds.Add((at, frame.Kinds[0]));
                errors.Add((at, Math.Abs(frame.Joints[0] - Truth(at))));
            });

            Assert.That(kinds.Where(k => k.At > 12.05 && k.At < 13.05).Select(k => k.Kind), Is.Not.Empty.And.All.EqualTo(PredictionKind.Planned));
            Assert.That(errors.Where(e => e.At > 12 && e.At < 13).Max(e => e.Error), Is.LessThan(0.01), "the displayed motion follows the plan");
            Assert.That(kinds.Where(k => k.At > 13.25).Select(k => k.Kind), Has.None.EqualTo(PredictionKind.Planned));
            Assert.That(errors.Where(e => e.At > 13.5).Max(e => e.Error), Is.LessThan(0.01), "the robot stands still");
        }

        [Test]
        public void Tick_PlanCancelled_Predicts()
        {
            var session = NewSession();
            session.Listener.Planned(Straight(11, 20), HeadsetTime.FromSeconds(11));
            var kinds = new List<PredictionKind>();
            Drive(session, 11, 12, t => t - 11, (_, frame) => kinds.Add(frame.Kinds[0]));
            Assert.That(kinds.Last(), Is.EqualTo(PredictionKind.Planned));

            session.Listener.Planned(new JointTrajectoryMessage(ControlTime.FromSeconds(12), new[] { "shoulder" }, Array.Empty<JointTrajectoryPoint>()), HeadsetTime.FromSeconds(12));
            Drive(session, 12, 12.5, t => t - 11, (_, frame) => kinds.Add(frame.Kinds[0]));

            Assert.That(kinds.Last(), Is.EqualTo(PredictionKind.Predicted));
        }

        [Test]
        public void Tick_SamplesStop_DoesNotContinueThePlan()
        {
            var session = NewSession();
            session.Listener.Planned(Straight(11, 20), HeadsetTime.FromSeconds(11));
            Drive(session, 11, 12, t => t - 11, (_, _) => { });

            var frame = session.Tick(HeadsetTime.FromSeconds(13));

            Assert.That(frame.Kinds[0], Is.EqualTo(PredictionKind.Held));
        }

        [Test]
        public void Planned_BeforeTheClockIsKnown_AppliesOnceKnown()
        {
            var session = NewSession(isClockKnown: false);
            session.Listener.Planned(Straight(11, 20), HeadsetTime.FromSeconds(11));
            session.Tick(HeadsetTime.FromSeconds(11));
            var kind = default(PredictionKind);
            Exchange(session, 11);

            Drive(session, 11, 12, t => t - 11, (_, frame) => kind = frame.Kinds[0]);

            Assert.That(kind, Is.EqualTo(PredictionKind.Planned));
        }

        [Test]
        public void Planned_StampInTheFuture_IsDropped()
        {
            var session = NewSession();
            session.Listener.Planned(Straight(15, 25), HeadsetTime.FromSeconds(11));

            Drive(session, 11, 12, t => t - 11, (_, frame) => Assert.That(frame.Kinds[0], Is.Not.EqualTo(PredictionKind.Planned)));

            Assert.That(session.Drops[DropReason.StampInFuture], Is.EqualTo(1));
        }

        [Test]
        public void Planned_JointsOfAnotherRobot_AreDropped()
        {
            var session = NewSession();

            session.Listener.Planned(new JointTrajectoryMessage(
                ControlTime.FromSeconds(11), new[] { "wing" }, new[] { new JointTrajectoryPoint(TimeSpan.Zero, new[] { 1.0 }) }), default);

            Assert.That(session.Drops[DropReason.UnknownJoint], Is.EqualTo(1));
        }

        [TestCase("hold", true)]
        [TestCase("quadratic", false)]
        public void Planned_FollowingDisabled_IsIgnored(string predictor, bool follow)
        {
            var session = NewSession(prediction: new PredictionSettings(predictor, followPlan: follow));
            session.Listener.Planned(Straight(11, 20), HeadsetTime.FromSeconds(11));

            Drive(session, 11, 12, t => t - 11, (_, frame) => Assert.That(frame.Kinds[0], Is.Not.EqualTo(PredictionKind.Planned)));
        }

        static JointTrajectoryMessage Straight(double from, double to) => new JointTrajectoryMessage(ControlTime.FromSeconds(from), new[] { "shoulder" }, new[]
        {
            new JointTrajectoryPoint(TimeSpan.Zero, new[] { 0.0 }),
            new JointTrajectoryPoint(Lengths.Seconds(to - from), new[] { to - from }),
        });

        static CompensationSession NewSession(bool isClockKnown = true, PredictionSettings prediction = null)
        {
            var session = new CompensationSession(
                new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), prediction),
                TestRobot.Model, new SetClock());
            for (var i = 0; isClockKnown && i < 100; i++) Exchange(session, 10 + i * 0.01);
            return session;
        }

        // Adds an exchange between clocks with zero offset.
        static void Exchange(CompensationSession session, double at)
        {
            var control = ControlTime.FromSeconds(at);
            session.Clock.Add(new SyncExchange(
                HeadsetTime.FromSeconds(at) - Lengths.Ms(1), control, control, HeadsetTime.FromSeconds(at) + Lengths.Ms(1)), out _);
        }

        // Runs 60 frames per second. A sample is taken every 50 ms and arrives 60 ms later. The elbow is at rest.
        static void Drive(CompensationSession session, double from, double to, Func<double, double> truth, Action<double, DisplayFrame> seen)
        {
            var next = Math.Ceiling(from / 0.05) * 0.05 - 0.2;
            for (var at = from; at < to; at += 1 / 60.0)
            {
                for (; next + 0.06 <= at; next += 0.05)
                    session.Listener.Received(
                        new JointStateMessage(ControlTime.FromSeconds(next), new[] { "shoulder", "elbow" }, new[] { truth(next), 0 }),
                        HeadsetTime.FromSeconds(next + 0.06));
                Exchange(session, at);
                seen(at + 0.04, session.Tick(HeadsetTime.FromSeconds(at)));
            }
        }
    }
}
