using System;
using System.Collections.Generic;
using System.Linq;
using MathNet.Numerics.Statistics;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    public class VirtualCellTests
    {
        static double Rms(IEnumerable<double> values) => Math.Sqrt(values.Average(v => v * v));

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        public void Run_DefaultCell_CompensationRemovesMostOfTheError(int seed)
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings(), seed);
            run.Run(6);

            run.Run(20);

            Assert.That(run.Errors, Has.Count.EqualTo(run.Frames), "all current");
            Assert.That(Rms(run.HoldErrors), Is.GreaterThan(0.01), "the uncompensated error is large");
            Assert.That(1 - Rms(run.Errors) / Rms(run.HoldErrors), Is.GreaterThan(0.7), "seed " + seed);
        }

        [Test]
        public void PlanLag_SetToNull_DeliversTheMessagesInTransit()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings());
            run.Cell.PlanLag = TimeSpan.Zero;
            var plans = 0;
            run.Session.Intake.PlanJudged += (arrival, reason) => plans++;
            run.Run(5 + 2 / 60.0);
            var before = plans;

            run.Cell.PlanLag = null;
            run.Run(1);

            Assert.That(plans - before, Is.EqualTo(1), "the message that was sent in the last 55 ms");
        }

        [Test]
        public void Settings_Default_AreRefused()
        {
            var cell = new VirtualCellRun(VirtualCellRun.Settings()).Cell;

            Assert.Throws<InputException>(() => cell.Settings = default);
        }

        // A cycle of the cell takes about eleven seconds. Scoring starts after three seconds, as in the demo.
        [Category("Study")]
        [Test]
        public void Run_DefaultSettings_ReductionIsAboveTheLimitInEachCycle(
            [Values("wifi", "busy-wifi")] string network, [Values(21, 22, 23)] int seed)
        {
            var run = new VirtualCellRun(new VirtualCellSettings(50, 55, 105, 0, 0, NetworkProfile.Named(network)), seed);
            double Reduction(double seconds)
            {
                run.Run(seconds);
                return 1 - Rms(run.Errors) / Rms(run.HoldErrors);
            }

            run.Run(3);
            var first = Reduction(run.CycleSeconds - 3);
            // The start of the motion came before the first sample, and each joint must repeat a move before its next start is predicted.
            run.Run(4);
            var second = Reduction(run.CycleSeconds - 4);
            var fromThird = Reduction(2 * run.CycleSeconds);

            Assert.That(first, Is.GreaterThan(0.83), "first cycle, seed " + seed);
            Assert.That(second, Is.GreaterThan(0.98), "second cycle, seed " + seed);
            Assert.That(fromThird, Is.GreaterThan(0.94), "from the third cycle on, seed " + seed);
        }

        [Test]
        public void Run_OtherFrameRate_DeliversTheSameSamples()
        {
            var settings = VirtualCellRun.Settings(jitterMs: 80, loss: 0.1);
            var at60 = new VirtualCellRun(settings).Run(10);
            var at25 = new VirtualCellRun(settings, fps: 25).Run(10);

            var count = Math.Min(at60.Taken.Count, at25.Taken.Count);

            Assert.That(count, Is.GreaterThan(150));
            Assert.That(at25.Taken.Take(count).Select(a => a.At.SinceEpoch.Ticks), Is.EqualTo(at60.Taken.Take(count).Select(a => a.At.SinceEpoch.Ticks)));
            Assert.That(at25.Taken.Take(count).Select(a => a.Message.Positions[0]), Is.EqualTo(at60.Taken.Take(count).Select(a => a.Message.Positions[0])));
        }

        [Test]
        public void Run_OtherSeed_DeliversOtherSamples()
        {
            var one = new VirtualCellRun(VirtualCellRun.Settings(), seed: 1).Run(3);
            var two = new VirtualCellRun(VirtualCellRun.Settings(), seed: 2).Run(3);

            Assert.That(two.Taken.Take(20).Select(a => a.At.SinceEpoch), Is.Not.EqualTo(one.Taken.Take(20).Select(a => a.At.SinceEpoch)));
        }

        [TestCase(20)]
        [TestCase(100)]
        public void Settings_SamplingInterval_AppliesFromTheNextSample(double samplingMs)
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings()).Run(6);
            run.Taken.Clear();

            run.Cell.Settings = VirtualCellRun.Settings(samplingMs);
            run.Run(10);

            var steps = run.Taken.Skip(10).Zip(run.Taken.Skip(11), (a, b) => (b.Message.Stamp - a.Message.Stamp).TotalMilliseconds).ToArray();
            Assert.That(steps.Min(), Is.EqualTo(samplingMs).Within(0.01), "except for the skew");
            Assert.That(steps.Max(), Is.EqualTo(samplingMs).Within(0.01));
            Assert.That(run.Taken.Count, Is.EqualTo(10_000 / samplingMs).Within(6));
        }

        [Test]
        public void Settings_Latency_IsMeasuredByTheSession()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings()).Run(6);

            run.Cell.Settings = VirtualCellRun.Settings(latencyMinMs: 200, latencyMaxMs: 240);
            run.Run(15);

            var measured = run.Statistics.ApplicationLatency.Value.TotalMilliseconds;
            Assert.That(measured, Is.EqualTo(220).Within(8));
        }

        [Test]
        public void Settings_Loss_EqualsTheShareOfMissingSamples()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings(loss: 0.3)).Run(60);

            var missing = 1 - run.Taken.Count / (60 / 0.05);

            Assert.That(missing, Is.EqualTo(0.3).Within(0.05));
        }

        [Test]
        public void Settings_JitterBeyondTheInterval_ReordersSamples()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings(jitterMs: 200)).Run(20);

            var late = run.Taken.Zip(run.Taken.Skip(1), (a, b) => b.Message.Stamp < a.Message.Stamp).Count(isLate => isLate);
            var arrivals = run.Taken.Select(a => a.At.SinceEpoch).ToArray();

            Assert.That(late, Is.GreaterThan(20));
            Assert.That(arrivals, Is.Ordered, "samples are delivered in order of arrival");
            Assert.That(new VirtualCellRun(VirtualCellRun.Settings()).Run(20).Taken.Select(a => a.Message.Stamp.SinceEpoch), Is.Ordered);
        }

        [Test]
        public void Clock_StepsAndChangesItsRate_IsFollowedByTheSession()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings()).Run(20);
            Assert.That(run.Statistics.Clock.Skew, Is.EqualTo(-37e-6).Within(5e-6), "the headset clock is slower");

            run.Clock.Set(run.Now, TimeSpan.FromSeconds(-2000), 200e-6);
            run.Run(2);
            run.Run(40);

            var now = run.Now;
            var statistics = run.Statistics;
            Assert.That(statistics.ClockSteps, Is.EqualTo(1));
            Assert.That(statistics.Clock.Skew, Is.EqualTo(-200e-6).Within(5e-6));
            Assert.That((statistics.Clock.ToControl(now) - run.Clock.At(now)).TotalMilliseconds, Is.EqualTo(0).Within(0.3));
            Assert.That(1 - Rms(run.Errors) / Rms(run.HoldErrors), Is.GreaterThan(0.7));
        }

        [Test]
        public void Clock_OnlyRateChanged_DoesNotStep()
        {
            var clock = new VirtualClock(HeadsetTime.FromSeconds(10), TimeSpan.FromSeconds(5), 1e-4);
            var before = clock.At(HeadsetTime.FromSeconds(110));

            clock.Set(HeadsetTime.FromSeconds(110), TimeSpan.FromSeconds(5), -2e-4);

            Assert.That(before, Is.EqualTo(ControlTime.FromSeconds(115.01)));
            Assert.That(clock.At(HeadsetTime.FromSeconds(110)), Is.EqualTo(before));
            Assert.That(clock.At(HeadsetTime.FromSeconds(210)), Is.EqualTo(before + TimeSpan.FromTicks((long)(99.98 * TimeSpan.TicksPerSecond))));
        }

        [TestCase(1000, 55, 105, 0, 0)]
        [TestCase(5, 2000, 2000, 0, 0, Category = "Study")]
        [TestCase(50, 0, 2000, 0, 0)]
        [TestCase(50, 55, 105, 1000, 0)]
        [TestCase(50, 55, 105, 0, 1)]
        [TestCase(1000, 2000, 2000, 1000, 0.9)]
        [TestCase(5, 0, 0, 1000, 0.5, Category = "Study")]
        public void Run_ExtremeSettings_PoseIsOftenNotCurrent(
            double samplingMs, double latencyMinMs, double latencyMaxMs, double jitterMs, double loss)
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings()).Run(10);
            run.Cell.Settings = VirtualCellRun.Settings(samplingMs, latencyMinMs, latencyMaxMs, jitterMs, loss);
            run.Run(5);

            run.Run(30);

            Assert.That(run.Errors.Count, Is.LessThan(0.6 * run.Frames), "share of current frames");
            if (run.Errors.Count > 0) Assert.That(Rms(run.Errors), Is.LessThan(0.7 * Rms(run.HoldErrors)),
                "current frames have a smaller error than hold");
        }

        [Test]
        public void Run_AfterALongSleep_DeliversOnlyRecentSamples()
        {
            var run = new VirtualCellRun(VirtualCellRun.Settings()).Run(10);
            run.Taken.Clear();

            run.Sleep(3600);
            run.Run(1 / 60.0);

            var dropped = run.Session.Drops[DropReason.SlowReader];
            Assert.That(run.Taken.Count + dropped, Is.InRange(30, 42), "the samples of two seconds and the samples in flight");
            run.Run(10);
            Assert.That(run.Session.Tick(run.Now).State, Is.EqualTo(PoseState.Current));
        }

        [TestCase(4.9, 55, 105, 0, 0, "sampling interval")]
        [TestCase(50, -1, 105, 0, 0, "minimum latency")]
        [TestCase(50, 55, 54, 0, 0, "maximum latency")]
        [TestCase(50, 55, 105, 1001, 0, "jitter")]
        [TestCase(50, 55, 105, 0, 1.1, "loss")]
        [TestCase(double.NaN, 55, 105, 0, 0, "sampling interval")]
        public void Settings_OutOfRange_AreRefused(double sampling, double min, double max, double jitter, double loss, string named)
        {
            var error = Assert.Throws<InputException>(() => VirtualCellRun.Settings(sampling, min, max, jitter, loss));

            Assert.That(error.Message, Does.StartWith(named + ":"));
        }
    }
}
