using System;
using Nowpose.Latency;
using Nowpose.Latency.Sweep;
using NUnit.Framework;
using Nowpose.Messages;

namespace Nowpose.Tests.Core.Latency.Sweep
{
    public class LoadSensitivityTests
    {
        const int Seeds = 8;

        static readonly SweepPlan DefaultPlan = new SweepPlan();
        static readonly SweepPlan Upwards = new SweepPlan(goesDown: false);

        /// <summary>Returns a CPU time of the camera in ms. It scatters by 5 % about 2 ms and does not depend on the load of the GPU.</summary>
        static double ConstantTime(SimulatedSweep sweep) => 2 * (1 + 0.05 * sweep.Normal());

        static void AllAre(LoadSight sight, SweepPlan plan, Func<SimulatedSweep, Func<double, int, double?>> source)
        {
            for (var seed = 1; seed <= Seeds; seed++)
            {
                var sweep = new SimulatedSweep(plan, seed);

                var judged = LoadSensitivity.Judge(sweep.Rows(source(sweep)));

                Assert.That(judged.Sight, Is.EqualTo(sight), "seed " + seed + ": " + judged.Words);
            }
        }

        [Test]
        public void GpuTime_DefaultSweep_RespondsToLoad() => AllAre(LoadSight.Seen, DefaultPlan, sweep => (t, v) => sweep.GpuMs(t, v));

        [Test]
        public void GpuTime_ShortSweepOfSmallLoads_RespondsToLoad() =>
            AllAre(LoadSight.Seen, new SweepPlan(300_000, 5, 2, 0), sweep => (t, v) => sweep.GpuMs(t, v));

        // Half a second per load is too short to estimate a trend of the render time. The source must be accepted nevertheless.
        [Test]
        public void GpuTime_SweepUpWithHalfASecondPerLoad_RespondsToLoad() => AllAre(
            LoadSight.Seen, new SweepPlan(steps: 21, secondsPerLoad: 0.5, settleSeconds: 0, goesDown: false), sweep => (t, v) => sweep.GpuMs(t, v));

        [Test]
        public void GpuTime_DecreasesWhileTheLoadRises_RespondsToLoad() =>
            AllAre(LoadSight.Seen, Upwards, sweep => (t, v) => Math.Max(0.1, sweep.GpuMs(t, v) - 0.03 * t));

        // Readbacks are polled once per frame, so their times are multiples of the frame time.
        [TestCase(60)]
        [TestCase(90)]
        public void CompletionTime_RoundedUpToFrames_RespondsToLoad(int hertz) => AllAre(
            LoadSight.Seen, DefaultPlan, sweep => (t, v) => Math.Ceiling(sweep.GpuMs(t, v) * hertz / 1000) * 1000 / hertz);

        [Test]
        public void GpuTime_ReportedInEveryFourthFrame_RespondsToLoad() =>
            AllAre(
                LoadSight.Seen, DefaultPlan,
                sweep => (t, v) => sweep.GpuMs(t, v) is double ms && Math.Round(t * 60) % 4 == 0 ? ms : (double?)null);

        [Test]
        public void CameraTime_Constant_DoesNotRespondToLoad() => AllAre(LoadSight.Unseen, DefaultPlan, sweep => (t, v) => ConstantTime(sweep));

        [Test]
        public void CameraTime_ConstantInAShortSweep_DoesNotRespondToLoad() => AllAre(
            LoadSight.Unseen, new SweepPlan(steps: 4, secondsPerLoad: 0.5), sweep => (t, v) => ConstantTime(sweep));

        [TestCase(0.01)]
        [TestCase(0.05)]
        [TestCase(-0.01)]
        public void CameraTime_LinearTrend_DoesNotRespondToLoad(double msPerSecond)
        {
            AllAre(LoadSight.Unseen, DefaultPlan, sweep => (t, v) => ConstantTime(sweep) + (msPerSecond < 0 ? 2 : 0) + msPerSecond * t);
            AllAre(LoadSight.Unseen, Upwards, sweep => (t, v) => ConstantTime(sweep) + (msPerSecond < 0 ? 2 : 0) + msPerSecond * t);
        }

        [TestCase(20)]
        [TestCase(60)]
        public void CameraTime_WarmsUp_DoesNotRespondToLoad(double timeConstantSeconds) => AllAre(
            LoadSight.Unseen, Upwards, sweep => (t, v) => ConstantTime(sweep) + 1 - Math.Exp(-t / timeConstantSeconds));

        // The processor changes its speed once. In a sweep in one direction, this would look like an effect of the load.
        [TestCase(30)]
        [TestCase(60)]
        [TestCase(100)]
        public void CameraTime_StepsOnce_DoesNotRespondToLoad(double atSeconds) =>
            AllAre(LoadSight.Unseen, DefaultPlan, sweep => (t, v) => ConstantTime(sweep) + (t < atSeconds ? 0 : 0.8));

        [Test]
        public void CameraTime_ChangesTooLittleWithTheLoad_CountsAsNotResponding() =>
            AllAre(LoadSight.Unseen, DefaultPlan, sweep => (t, v) => ConstantTime(sweep) + 0.1 * v / SweepPlan.MaxVertices);

        [Test]
        public void Words_NoResponseToLoad_AreOneLineWithNumbersAndRemedy()
        {
            var sweep = new SimulatedSweep(DefaultPlan, 1);

            var words = LoadSensitivity.Judge(sweep.Rows((t, v) => ConstantTime(sweep))).Words;

            Assert.That(words, Does.Match(
                SweepMessages.Rise(200_000, 1_800_000, "camera_cpu", 2, 99).Replace("2.00", "2\\.\\d\\d").Replace("99.00", "2\\.\\d\\d")));
            Assert.That(words, Does.EndWith(SweepMessages.MeasureGpu));
        }

        [Test]
        public void Words_ResponseToLoad_StateTheTimesAtBothEndsOfTheSweep()
        {
            var sweep = new SimulatedSweep(DefaultPlan, 1) { Source = RenderTimeSourceKind.DisplayGpuTime };

            var judged = LoadSensitivity.Judge(sweep.Rows((t, v) => sweep.GpuMs(t, v)));

            Assert.That(judged.Source, Is.EqualTo(RenderTimeSourceKind.DisplayGpuTime));
            Assert.That(judged.Words, Does.Match("^" + SweepMessages.Responds(
                SweepMessages.Rise(200_000, 1_800_000, "display_gpu_time", 5, 99).Replace("5.00", "5\\.\\d\\d").Replace("99.00", "[\\d.]+")) + "$"));
        }

        [Test]
        public void Judge_OneLoad_IsUnclear()
        {
            var sweep = new SimulatedSweep(DefaultPlan, 1);

            var judged = LoadSensitivity.Judge(sweep.Rows((t, v) => sweep.GpuMs(t, v)).FindAll(row => row.Vertices == 0));

            Assert.That(judged.Sight, Is.EqualTo(LoadSight.Unclear));
            Assert.That(
                judged.Words,
                Is.EqualTo(SweepMessages.TooFewData("camera_cpu", loads: 1, minTimes: 15)));
        }

        [Test]
        public void Judge_FewRows_IsUnclear()
        {
            var sweep = new SimulatedSweep(DefaultPlan, 1);
            var frame = 0;

            var judged = LoadSensitivity.Judge(sweep.Rows((t, v) => sweep.GpuMs(t, v)).FindAll(row => frame++ % 30 == 0));

            Assert.That(judged.Sight, Is.EqualTo(LoadSight.Unclear));
        }

        [Test]
        public void Judge_NoRenderTimes_StatesThatTheyAreMissing()
        {
            var judged = LoadSensitivity.Judge(new SimulatedSweep(DefaultPlan, 1).Rows((t, v) => null));

            Assert.That(judged.Sight, Is.EqualTo(LoadSight.Unseen));
            Assert.That(judged.Words, Is.EqualTo(SweepMessages.NotMeasured));
        }

        [Test]
        public void Judge_NoRows_StatesThatRenderTimesAreMissing()
        {
            Assert.That(LoadSensitivity.Judge(Array.Empty<SweepRow>()).Words, Is.EqualTo(SweepMessages.NotMeasured));
        }

        [Test]
        public void GpuTime_AnyOrderOfLoads_RespondsToLoad()
        {
            var sweep = new SimulatedSweep(DefaultPlan, 3);
            var rows = sweep.Rows((t, v) => sweep.GpuMs(t, v));
            rows.Sort((a, b) => (a.Vertices * 7919L % 1009).CompareTo(b.Vertices * 7919L % 1009));

            Assert.That(LoadSensitivity.Judge(rows).Sight, Is.EqualTo(LoadSight.Seen));
        }
    }
}
