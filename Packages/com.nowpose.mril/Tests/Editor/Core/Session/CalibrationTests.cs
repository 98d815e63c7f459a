using System;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Network;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class CalibrationTests
    {
        const RenderTimeSourceKind Source = RenderTimeSourceKind.DisplayGpuTime;

        static LatencyProfile Profile(double visuMs = 62, double? limitMs = 15, double? validToMs = null) => new LatencyProfile(
            visuMs, 1, "HoloLens 2", 60, new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc), CalibrationMethod.VisibleLight, 300, limitMs, Source, validToMs);

        static SimulatedSession Running(OutsideRangeResponse outsideRange = OutsideRangeResponse.Fade)
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, 3, outsideRange: outsideRange);
            simulated.Run(10);
            return simulated;
        }

        static void Render(CompensationSession session, double renderMs, int frames = 50, RenderTimeSourceKind source = Source)
        {
            for (var i = 0; i < frames; i++) session.Rendered(Lengths.Ms(renderMs), source);
        }

        [Test]
        public void Calibrate_WhileRunning_ChangesTheDisplayTimeAndKeepsTheState()
        {
            var session = Running().Session;
            var before = session.Tick(HeadsetTime.FromSeconds(10)).DisplayTime.Value;

            session.Calibrate(Profile(62));

            var after = session.Tick(HeadsetTime.FromSeconds(10));
            Assert.That((after.DisplayTime.Value - before).TotalMilliseconds, Is.EqualTo(22).Within(0.01));
            Assert.That(after.State, Is.EqualTo(PoseState.Current), "samples and clock are kept");
            Assert.That(session.Profile.Measurements, Is.EqualTo(300));
            Assert.That(session.Statistics(default).VisualisationLatency, Is.EqualTo(Lengths.Ms(62)));
        }

        [Test]
        public void Calibrate_WhileRunning_SetsTheMonitorsRange()
        {
            var session = Running().Session;
            Render(session, 20);
            var before = session.Statistics(default).RangeUnknownReason;

            session.Calibrate(Profile());
            Render(session, 20, 1);
            var outside = session.Tick(HeadsetTime.FromSeconds(10)).State;
            session.Calibrate(Profile(limitMs: 30));
            Render(session, 20, 1);

            Assert.That(before, Is.EqualTo(RangeUnknownReason.NoLimit));
            Assert.That(outside, Is.EqualTo(PoseState.OutsideRange));
            Assert.That(session.Tick(HeadsetTime.FromSeconds(10)).State, Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void Calibrate_RenderTimesFromAnotherSource_RangeIsUnknown()
        {
            var session = Running().Session;
            session.Calibrate(Profile());

            Render(session, 40, source: RenderTimeSourceKind.GpuCompletion);

            Assert.That(session.Statistics(default).RangeUnknownReason, Is.EqualTo(RangeUnknownReason.OtherSource));
            Assert.That(session.Tick(HeadsetTime.FromSeconds(10)).State, Is.EqualTo(PoseState.Current));
        }

        [Test]
        public void Calibrate_LimitNotReached_RangeIsUnknownBeyondTheMeasuredMaximum()
        {
            var session = Running().Session;
            session.Calibrate(Profile(limitMs: null, validToMs: 12));
            Render(session, 11);
            var inside = session.Statistics(default).Range;

            Render(session, 14);

            Assert.That(inside, Is.EqualTo(RangeState.Inside));
            Assert.That(session.Statistics(default).Range, Is.EqualTo(RangeState.Unknown));
            Assert.That(session.Statistics(default).RangeUnknownReason, Is.EqualTo(RangeUnknownReason.BeyondMeasured));
        }

        [Test]
        public void Visualisation_SetByHand_RemovesTheProfile()
        {
            var session = Running().Session;
            session.Calibrate(Profile());

            session.Visualisation = VisualisationLatency.FromMilliseconds(50);

            Assert.That(session.Profile, Is.Null);
            Assert.That(session.Statistics(default).VisualisationLatency, Is.EqualTo(Lengths.Ms(50)));
        }

        [Test]
        public void Calibrate_Null_RestoresTheSettings()
        {
            var session = Running().Session;
            session.Calibrate(Profile());

            session.Calibrate(null);

            Assert.That(session.Profile, Is.Null);
            Assert.That(session.Visualisation.Length, Is.EqualTo(Lengths.Ms(40)));
            Assert.That(session.Statistics(default).RangeUnknownReason, Is.EqualTo(RangeUnknownReason.NoLimit));
        }

        [Test]
        public void Calibrate_ProfileWithoutRange_UsesTheConfiguredRange()
        {
            var settings = new SessionSettings(
                new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40), range: new ConstantLatencyRange(15, Source));
            var session = new CompensationSession(settings, TestRobot.Model, new SetClock());

            session.Calibrate(Profile(limitMs: 12));
            var known = session.Range.Limit;
            session.Calibrate(Profile(limitMs: null));
            Render(session, 20);

            Assert.That(known, Is.EqualTo(Lengths.Ms(12)));
            Assert.That(session.Range, Is.SameAs(settings.Range));
            Assert.That(session.Statistics(default).Range, Is.EqualTo(RangeState.Outside));
        }

        [Test]
        public void SessionSettings_ProfileWithoutRange_KeepsTheConfiguredRange()
        {
            var range = new ConstantLatencyRange(15, Source);

            var settings = new SessionSettings(
                new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(10), range: range, profile: Profile(limitMs: null));

            Assert.That(settings.Range, Is.SameAs(range));
        }

        [Test]
        public void SessionSettings_Profile_ReplacesLatencyAndRange()
        {
            var profile = Profile();
            var settings = new SessionSettings(
                new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(10), range: new ConstantLatencyRange(3, Source), profile: profile);

            var session = new CompensationSession(settings, TestRobot.Model, new SetClock());

            Assert.That(session.Profile, Is.SameAs(profile));
            Assert.That(session.Visualisation.Length, Is.EqualTo(Lengths.Ms(62)));
            Assert.That(settings.Range.Limit, Is.EqualTo(Lengths.Ms(15)));
        }

        [TestCase(OutsideRangeResponse.Fade, false)]
        [TestCase(OutsideRangeResponse.GoOn, false)]
        [TestCase(OutsideRangeResponse.Hold, true)]
        public void OutsideRange_Response_DeterminesPoseAndReportedState(OutsideRangeResponse response, bool isHeld)
        {
            var simulated = Running(response);
            simulated.Session.Calibrate(Profile(40));
            var watch = new SessionWatch();
            var changes = SessionChange.None;
            double farthest = 0;
            var frames = 0;

            simulated.Run(2, (frame, light) =>
            {
                simulated.Session.Rendered(Lengths.Ms(20), Source);
                changes |= watch.Changed(frame);
                if (frame.Range != RangeState.Outside) return;
                frames++;
                Assert.That(frame.State, Is.EqualTo(PoseState.OutsideRange));
                Assert.That(frame.OutsideRange, Is.EqualTo(response));
                for (var i = 0; i < frame.Joints.Length; i++) farthest = Math.Max(farthest, Math.Abs(frame.Joints[i] - frame.HeldJoints[i]));
            });

            Assert.That(frames, Is.GreaterThan(100));
            Assert.That(farthest, isHeld ? (NUnit.Framework.Constraints.Constraint)Is.EqualTo(0) : Is.GreaterThan(0.05));
            Assert.That(changes & SessionChange.LeftRange, Is.EqualTo(SessionChange.LeftRange));
            Assert.That(changes & SessionChange.Stale, Is.EqualTo(SessionChange.None),
                "the pose is held because of the setting, not because samples are missing");
        }

        [Test]
        public void OutsideRange_HoldResponseAndSamplesStop_IsHeld()
        {
            var simulated = Running(OutsideRangeResponse.Hold);
            simulated.Session.Calibrate(Profile(40));
            Render(simulated.Session, 20);
            simulated.IsGatewayUp = false;
            var last = PoseState.Current;

            simulated.Run(1, (frame, light) => last = frame.State);

            Assert.That(last, Is.EqualTo(PoseState.Held));
        }

        [Test]
        public void OutsideRange_HoldResponseAndBackInside_PredictsAgain()
        {
            var simulated = Running(OutsideRangeResponse.Hold);
            simulated.Session.Calibrate(Profile(40));
            Render(simulated.Session, 20);
            simulated.Run(1);

            Render(simulated.Session, 10);
            double worst = 0;
            simulated.Run(1, (frame, light) => worst = Math.Max(worst, Math.Abs(frame.Joints[0] - SimulatedSession.TruthAt(light).Shoulder)));

            Assert.That(worst, Is.LessThan(0.02), "a held pose is up to 0.2 rad away");
        }

        [Test]
        public void Diagnostics_DisplayTimeSourceInUse_ContainTheDifference()
        {
            var simulated = Running();
            var clock = new SetClock();
            var session = new CompensationSession(
                new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), TestRobot.Model, clock);
            session.DisplayTimeSource = new ConstantDisplayTime();
            for (var i = 0; i < 60; i++) session.Tick(HeadsetTime.FromSeconds(i / 60.0));

            var values = session.Listener.Diagnostics().Values.ToDictionary(v => v.Key, v => v.Value);

            Assert.That(values["l_visu_ms"], Is.EqualTo("47"));
            Assert.That(values["display_time_difference_ms"], Is.EqualTo("7"));
        }

        sealed class ConstantDisplayTime : IDisplayTimeSource
        {
            public HeadsetTime? LightOf(HeadsetTime frameStart) => frameStart + TimeSpan.FromMilliseconds(47);
        }
    }
}
