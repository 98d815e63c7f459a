using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Messages;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Session.Cell;
using Nowpose.Session.Hindcast;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>
    /// Tests which frames the estimated error excludes: frames near a clock step, in a gap between samples, or with a render time outside
    /// the range.
    /// </summary>
    public class HindcastIntervalTests
    {
        const int Seed = 7;

        static SessionStatistics Statistics(SimulatedSession simulated) =>
            simulated.Session.Statistics(HeadsetTime.FromSeconds(simulated.Now));

        [Test]
        public void Statistics_Unsynchronised_HaveNoError()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSyncUp = false };
            simulated.Run(10);

            var statistics = Statistics(simulated);

            Assert.That(statistics.Samples, Is.GreaterThan(100));
            Assert.That(statistics.ErrorMm, Is.Null);
            Assert.That(statistics.HoldErrorMm, Is.Null);
            Assert.That(statistics.ErrorReduction, Is.Null);
        }

        [TestCase(3600)]
        [TestCase(-3600)]
        [TestCase(0.2)]
        [TestCase(-0.2)]
        public void Statistics_ControlClockSteps_ScoreOnlyLaterFrames(double stepSeconds)
        {
            var simulated = new SimulatedSession(NetworkProfile.Wifi, Seed);
            simulated.Run(20);
            var before = Statistics(simulated).HoldErrorMm.Value;
            var known = new List<double?>();

            simulated.Link.Step = Lengths.Seconds(stepSeconds);
            simulated.Run(20, (frame, light) => known.Add(simulated.Session.Statistics(frame.Start).HoldErrorMm));

            Assert.That(known.Last().Value, Is.EqualTo(before).Within(20).Percent);
            Assert.That(known.Where(k => k.HasValue).Max(), Is.LessThan(2 * before), "no frame is scored across the step");
        }

        [TestCase(3600)]
        [TestCase(-3600)]
        [TestCase(-0.2)]
        public void Statistics_ControlClockSteps_DiscardEarlierErrors(double stepSeconds)
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(20);

            simulated.Link.Step = Lengths.Seconds(stepSeconds);
            simulated.Run(0.3);
            simulated.IsSamplingByTest = true;
            simulated.Run(6);

            Assert.That(simulated.Session.Tick(HeadsetTime.FromSeconds(simulated.Now)).IsTimeTrusted, Is.True);
            Assert.That(Statistics(simulated).HoldErrorMm, Is.Null);
        }

        [Test]
        public void Statistics_SamplesStop_HaveNoErrorAfterTenSeconds()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(15);
            simulated.IsSamplingByTest = true;
            simulated.Run(8);
            var soon = Statistics(simulated).ErrorMm;

            simulated.Run(3);

            Assert.That(soon, Is.Not.Null);
            Assert.That(Statistics(simulated).ErrorMm, Is.Null);
        }

        [Test]
        public void Statistics_RenderTimeOutsideTheRange_HaveNoErrorUntilItIsInsideAgain()
        {
            var simulated = InsideTheRange(isLimitReached: true);
            var before = Statistics(simulated);

            Render(simulated, 30);
            simulated.Run(0.1);
            var outside = Statistics(simulated);
            Render(simulated, 5);
            simulated.Run(2);
            var after = Statistics(simulated);
            simulated.Session.RestartErrorRun();
            simulated.Run(2);
            var restarted = Statistics(simulated);

            AssertStated(before);
            Assert.That(outside.Range, Is.EqualTo(RangeState.Outside));
            AssertWithheld(outside, ErrorWithheldReason.OutsideRange);
            Assert.That((after.ErrorMm.HasValue, after.ErrorWithheld), Is.EqualTo((true, ErrorWithheldReason.None)),
                "the error is that of the frames inside the range");
            Assert.That(
                (after.ToolErrorOfRun, after.ErrorOfRunWithheld), Is.EqualTo(((DisplayedError?)null, ErrorWithheldReason.OutsideRange)),
                "part of this run cannot be scored");
            AssertStated(restarted);
        }

        [Test]
        public void Statistics_RenderTimeBeyondTheMeasuredRange_HaveTheReasonInsteadOfAnError()
        {
            var simulated = InsideTheRange(isLimitReached: false);

            Render(simulated, 30);
            simulated.Run(0.1);

            Assert.That(Statistics(simulated).Range, Is.EqualTo(RangeState.Unknown));
            AssertWithheld(Statistics(simulated), ErrorWithheldReason.BeyondMeasured);
        }

        [Test]
        public void Statistics_NoRangeAndRenderTimeAboveARefreshInterval_HaveTheReasonInsteadOfAnError()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Session.Conditions = new DisplayConditions("headset", 60);
            Render(simulated, 5);
            simulated.Run(8);
            var before = Statistics(simulated);

            Render(simulated, 18);
            simulated.Run(0.1);

            AssertStated(before);
            AssertWithheld(Statistics(simulated), ErrorWithheldReason.LongerThanRefresh);
        }

        // Without render times of the source for which the range was calibrated, late frames are not detected, even if another source reports short
        // times.
        [TestCase(RenderTimeSourceKind.CameraCpu, ErrorWithheldReason.OtherSource)]
        [TestCase(RenderTimeSourceKind.None, ErrorWithheldReason.NoRenderTime)]
        public void Statistics_LimitNoLongerMonitored_HaveTheReasonInsteadOfAnError(RenderTimeSourceKind source, object reason)
        {
            var simulated = InsideTheRange(isLimitReached: true);

            Render(simulated, 5, source);
            simulated.Run(0.1);
            var unmonitored = Statistics(simulated);
            Render(simulated, 5);
            simulated.Run(2);

            AssertWithheld(unmonitored, (ErrorWithheldReason)reason);
            Assert.That(Statistics(simulated).ErrorMm, Is.Not.Null);
            Assert.That(Statistics(simulated).ErrorOfRunWithheld, Is.EqualTo(reason), "part of this run cannot be scored");
        }

        [Test]
        public void Statistics_FirstRenderTimeArrivesLate_RunBeginsAtThatTime()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, range: Range(isLimitReached: true));
            simulated.Run(8);
            var before = Statistics(simulated);

            Render(simulated, 5);
            simulated.Run(4);

            AssertWithheld(before, ErrorWithheldReason.NoRenderTime);
            AssertStated(Statistics(simulated));
        }

        [Test]
        public void Statistics_DisplayTimesArePredicted_NeedNoRenderTime()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, range: Range(isLimitReached: true));
            simulated.Session.DisplayTimeSource = new Runtime();

            simulated.Run(8);

            Assert.That(Statistics(simulated).IsLightPredicted, Is.True);
            AssertStated(Statistics(simulated));
        }

        [TestCase(true, "outside range")]
        [TestCase(false, StateNames.BeyondMeasured)]
        public void Diagnostics_ErrorIsWithheld_ContainTheReason(bool isLimitReached, string reason)
        {
            var simulated = InsideTheRange(isLimitReached);
            Dictionary<string, string> Diagnostics() => SessionDiagnostics.Of(Statistics(simulated), CellFaults.None, "headset", default).Values
                .ToDictionary(each => each.Key, each => each.Value);
            var before = Diagnostics();

            Render(simulated, 30);
            simulated.Run(0.1);
            var outside = Diagnostics();

            Assert.That(before.Keys, Has.Member("error_mm").And.No.Member("error_withheld"));
            Assert.That(outside.Keys, Has.No.Member("error_mm").And.No.Member("reduction"));
            Assert.That(outside["error_withheld"], Is.EqualTo(reason));
        }

        sealed class Runtime : IDisplayTimeSource
        {
            public HeadsetTime? LightOf(HeadsetTime frameStart) => frameStart + Lengths.Ms(40);
        }

        static ConstantLatencyRange Range(bool isLimitReached) => new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime, isLimitReached);

        static SimulatedSession InsideTheRange(bool isLimitReached)
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed, range: Range(isLimitReached));
            Render(simulated, 5);
            simulated.Run(8);
            return simulated;
        }

        static void Render(SimulatedSession simulated, double ms, RenderTimeSourceKind source = RenderTimeSourceKind.DisplayGpuTime)
        {
            for (var i = 0; i < 100; i++) simulated.Session.Rendered(Lengths.Ms(ms), source);
        }

        static void AssertStated(SessionStatistics statistics)
        {
            Assert.That((statistics.ErrorMm.HasValue, statistics.ErrorReduction.HasValue, statistics.ToolErrorOfRun.HasValue), Is.EqualTo((true, true, true)));
            Assert.That(statistics.JointErrors.Select(joint => joint.Error), Is.All.Not.Null);
            Assert.That((statistics.ErrorWithheld, statistics.ErrorOfRunWithheld), Is.EqualTo((ErrorWithheldReason.None, ErrorWithheldReason.None)));
        }

        static void AssertWithheld(SessionStatistics statistics, ErrorWithheldReason reason)
        {
            Assert.That((statistics.ErrorMm.HasValue, statistics.ErrorReduction.HasValue, statistics.ToolErrorOfRun.HasValue), Is.EqualTo((false, false, false)));
            Assert.That(statistics.JointErrors.Select(joint => joint.Error), Is.All.Null);
            Assert.That((statistics.ErrorWithheld, statistics.ErrorOfRunWithheld), Is.EqualTo((reason, reason)));
        }

        [Test]
        public void Statistics_SamplesAheadOfTheDisplayTime_ScoreLaterFrames()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed) { IsSamplingByTest = true };
            simulated.Run(8);
            var known = 0;
            for (var i = 0; i < 120; i++)
            {
                var now = HeadsetTime.FromSeconds(simulated.Now);
                var ahead = Lengths.Ms(i < 60 ? 300 : 0);
                // The pause keeps the time stamps from going back, which would discard the waiting frames.
                if (i < 60 || i > 66)
                    simulated.Session.Listener.Received(new JointStateMessage(
                        simulated.Link.TrueOffset(now).ToControl(now) + ahead, new[] { "shoulder", "elbow" }, new[] { 0.01 * i, 0 }), now);
                simulated.Run(0.05);
                if (Statistics(simulated).HoldErrorMm.HasValue) known++;
            }

            Assert.That(known, Is.InRange(45, 53), "frames that cannot be scored do not delay later frames");
        }

        [Test]
        public void Statistics_StampsGoBack_IncludeFramesAgainImmediately()
        {
            var simulated = new SimulatedSession(NetworkProfile.Lan, Seed);
            simulated.Run(8);
            simulated.IsSamplingByTest = true;
            void Send(TimeSpan ahead)
            {
                var now = HeadsetTime.FromSeconds(simulated.Now);
                simulated.Session.Listener.Received(new JointStateMessage(
                    simulated.Link.TrueOffset(now).ToControl(now) + ahead, new[] { "shoulder", "elbow" },
                    new[] { Math.Sin(3 * simulated.Now), 0 }), now);
                simulated.Run(0.02);
            }
            // Runs long enough for all earlier errors to leave the statistics.
            for (var i = 0; i < 600; i++) Send(Lengths.Ms(900));
            var before = Statistics(simulated).HoldErrorMm;
            var sent = 0;

            while (Statistics(simulated).HoldErrorMm == null && sent < 100)
            {
                Send(TimeSpan.Zero);
                sent++;
            }

            Assert.That(before, Is.Null, "frames older than the samples cannot be scored");
            Assert.That(sent * 20, Is.LessThan(500), "ms; the stamps exceed the earlier stamps only after 900 ms");
        }
    }
}
