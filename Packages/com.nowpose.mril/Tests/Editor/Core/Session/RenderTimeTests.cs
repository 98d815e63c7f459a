using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Session.Hindcast;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class RenderTimeTests
    {
        const int Seed = 7;
        static readonly ConstantLatencyRange Range = new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime);

        static SimulatedSession Session(ConstantLatencyRange range) => new SimulatedSession(NetworkProfile.Lan, Seed, range: range);

        static List<PoseState> Run(SimulatedSession simulated, double renderMs, RenderTimeSourceKind source)
        {
            var states = new List<PoseState>();
            simulated.Run(1, (frame, light) =>
            {
                states.Add(frame.State);
                simulated.Session.Rendered(Lengths.Ms(renderMs), source);
            });
            return states;
        }

        [Test]
        public void Rendered_BeyondTheLimit_PoseIsNotCurrentUntilTheLoadFalls()
        {
            var simulated = Session(Range);
            simulated.Run(10);

            var low = Run(simulated, 10, RenderTimeSourceKind.DisplayGpuTime);
            var high = Run(simulated, 20, RenderTimeSourceKind.DisplayGpuTime);
            var range = simulated.Session.Tick(HeadsetTime.FromSeconds(simulated.Now)).Range;
            var fallen = Run(simulated, 10, RenderTimeSourceKind.DisplayGpuTime);

            Assert.That(low, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(high.Skip(10), Is.Not.Empty.And.All.EqualTo(PoseState.OutsideRange));
            Assert.That(range, Is.EqualTo(RangeState.Outside));
            Assert.That(fallen.Skip(40), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
        }

        // The system can halve the frame rate at a short render time, for example during a mixed reality capture.
        [TestCase(2, true)]
        [TestCase(4, true)]
        [TestCase(2, false)]
        public void Tick_FramesMissRefreshes_PoseIsNotCurrentUntilTheRateReturns(int refreshes, bool hasRange)
        {
            var simulated = Session(hasRange ? Range : null);
            simulated.Session.Conditions = new DisplayConditions(displayHz: 60);
            simulated.Run(10);

            var full = Run(simulated, 10, RenderTimeSourceKind.DisplayGpuTime);
            simulated.FrameSeconds = refreshes / 60.0;
            var slow = Run(simulated, 10, RenderTimeSourceKind.DisplayGpuTime);
            var statistics = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));
            simulated.FrameSeconds = 1 / 60.0;
            var returned = Run(simulated, 10, RenderTimeSourceKind.DisplayGpuTime);

            Assert.That(full, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(slow.Skip(9), Is.Not.Empty.And.All.EqualTo(PoseState.OutsideRange));
            Assert.That(statistics.Range, Is.EqualTo(RangeState.Outside));
            Assert.That(statistics.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.LowFrameRate));
            Assert.That(statistics.ErrorWithheld, Is.EqualTo(ErrorWithheldReason.LowFrameRate));
            Assert.That(returned.Skip(45), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
        }

        // The rate always shows these frames, so they cannot hide among the others.
        [Test]
        public void Statistics_FramesMissRefreshesForAWhile_AreLeftOutOfTheErrorOfTheRun()
        {
            var simulated = Session(null);
            simulated.Session.Conditions = new DisplayConditions(displayHz: 60);
            simulated.Run(10);
            simulated.FrameSeconds = 1 / 30.0;
            simulated.Run(2);
            simulated.FrameSeconds = 1 / 60.0;
            simulated.Run(5);

            var statistics = simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

            Assert.That(statistics.ErrorOfRunWithheld, Is.EqualTo(ErrorWithheldReason.None));
            Assert.That(statistics.ToolErrorOfRun.Value.Frames, Is.InRange(600, 900));
        }

        [Test]
        public void Tick_FramesMissRefreshesTwiceWithoutRange_EachEpisodeIsReportedWithItsEnd()
        {
            const SessionChange ofRange = SessionChange.LeftRange | SessionChange.EnteredRange;
            var (simulated, watch, changes) = (Session(null), new SessionWatch(), new List<SessionChange>());
            simulated.Session.Conditions = new DisplayConditions(displayHz: 60);
            simulated.Run(10);

            foreach (var refreshes in new[] { 1, 2, 1, 2, 1 })
            {
                simulated.FrameSeconds = refreshes / 60.0;
                simulated.Run(2, (frame, light) => changes.Add(watch.Changed(frame) & ofRange));
            }

            Assert.That(
                changes.Where(change => change != SessionChange.None),
                Is.EqualTo(new[] { SessionChange.LeftRange, SessionChange.EnteredRange, SessionChange.LeftRange, SessionChange.EnteredRange }));
        }

        [Test]
        public void Tick_RefreshRateUnknown_PoseStaysCurrentAtAnyFrameRate()
        {
            var simulated = Session(Range);
            simulated.FrameSeconds = 1 / 15.0;
            simulated.Run(10);

            Assert.That(Run(simulated, 10, RenderTimeSourceKind.DisplayGpuTime), Is.Not.Empty.And.All.EqualTo(PoseState.Current));
        }

        [TestCase(0, RangeState.Unknown)]
        [TestCase(5, RangeState.Unknown)]
        [TestCase(15, RangeState.Outside)]
        public void Tick_SomeOfFifteenFramesAreLate_IsOutsideOnlyIfMostAre(int late, RangeState state)
        {
            var session = Session(null).Session;
            session.Conditions = new DisplayConditions(displayHz: 60);
            var (now, frame) = (HeadsetTime.FromSeconds(1), (DisplayFrame)null);

            for (var i = 0; i < 150; i++)
            {
                now += Lengths.Ms(i % 15 < late ? 33 : 17);
                frame = session.Tick(now);
            }

            Assert.That(frame.Range, Is.EqualTo(state));
        }

        [Test]
        public void Tick_FramesComputedTwice_CountOnce()
        {
            var session = Session(null).Session;
            session.Conditions = new DisplayConditions(displayHz: 60);
            var (now, frame) = (HeadsetTime.FromSeconds(1), (DisplayFrame)null);

            for (var i = 0; i < 30; i++)
            {
                session.Tick(now += Lengths.Ms(28), isLast: false);
                frame = session.Tick(now += Lengths.Ms(5));
            }

            Assert.That(frame.Range, Is.EqualTo(RangeState.Outside));
        }

        [Test]
        public void Rendered_LimitFromAnotherSource_PoseStaysCurrent()
        {
            var simulated = Session(Range);
            simulated.Run(10);

            var states = Run(simulated, 20, RenderTimeSourceKind.GpuCompletion);

            Assert.That(states, Is.Not.Empty.And.All.EqualTo(PoseState.Current));
            Assert.That(simulated.Session.Statistics(default).RangeUnknownReason, Is.EqualTo(RangeUnknownReason.OtherSource));
        }

        [Test]
        public void Rendered_OutsideRangeWhileIncompleteOrHeld_ShowsTheMoreSevereState()
        {
            var simulated = Session(Range);
            var incomplete = Run(simulated, 20, RenderTimeSourceKind.DisplayGpuTime).First();
            simulated.Run(10);
            simulated.IsGatewayUp = false;
            simulated.Run(1);

            var gone = Run(simulated, 20, RenderTimeSourceKind.DisplayGpuTime);

            Assert.That(incomplete, Is.EqualTo(PoseState.Incomplete));
            Assert.That(gone, Is.Not.Empty.And.All.EqualTo(PoseState.Held));
        }

        [Test]
        public void Statistics_RenderTimes_NameSourceAndRange()
        {
            var simulated = Session(Range);
            var before = simulated.Session.Statistics(default);
            var later = simulated.Session.Statistics(HeadsetTime.FromSeconds(6));
            Run(simulated, 9.5, RenderTimeSourceKind.DisplayGpuTime);

            var after = simulated.Session.Statistics(default);

            Assert.That(before.RenderTime, Is.Null);
            Assert.That(before.RenderTimeSource, Is.EqualTo(RenderTimeSourceKind.None));
            Assert.That(before.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.TooFewFrames), "the source may not be selected yet");
            Assert.That(later.RangeUnknownReason, Is.EqualTo(RangeUnknownReason.NoRenderTime));
            Assert.That(after.RenderTime.Value.TotalMilliseconds, Is.EqualTo(9.5).Within(0.01));
            Assert.That(after.RenderTimeSource, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime));
            Assert.That(after.Range, Is.EqualTo(RangeState.Inside));
        }

        [TestCase(9.5, "inside")]
        [TestCase(16, "outside")]
        public void Diagnostics_RenderTimes_ContainTimeAndRange(double renderMs, string range)
        {
            var session = new CompensationSession(
                new SessionSettings(new ConnectionSettings("127.0.0.1"), default, range: Range), TestRobot.Model, new SetClock());
            var before = session.Listener.Diagnostics().Values.Select(v => v.Key).ToList();
            for (var i = 0; i < 20; i++) session.Rendered(Lengths.Ms(renderMs), RenderTimeSourceKind.DisplayGpuTime);

            var values = session.Listener.Diagnostics().Values.ToDictionary(v => v.Key, v => v.Value);

            Assert.That(before, Has.No.Member("render_ms").And.No.Member("range"), "unknown values are left out");
            Assert.That(values["render_ms"], Is.EqualTo(renderMs == 16 ? "16" : "9.5"));
            Assert.That(values["range"], Is.EqualTo(range));
        }
    }
}
