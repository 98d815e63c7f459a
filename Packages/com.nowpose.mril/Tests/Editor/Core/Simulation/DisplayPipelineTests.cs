using System;
using System.Collections.Generic;
using System.Linq;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    public class DisplayPipelineTests
    {
        static readonly DisplayPipelineSettings Steady = new DisplayPipelineSettings(scatter: 0, spikeChance: 0);

        static readonly double TrueLimitMs = Steady.RefreshMs - DisplayPipelineSettings.LatchMs;

        static PipelineFrame FiftiethFrame(double renderMs, DisplayPipelineSettings settings)
        {
            var display = new DisplayPipeline(1, settings);
            for (var frame = 0; frame < 49; frame++) display.Next(settings.VerticesOf(renderMs));
            return display.Next(settings.VerticesOf(renderMs));
        }

        static double VisualisationMs(double renderMs) => FiftiethFrame(renderMs, Steady).Visualisation.TotalMilliseconds;

        // Returns the displayed frames after the first 50, which are left out because the pipeline has not settled yet.
        static List<PipelineFrame> DisplayedFrames(double renderMs, int seed, int frames, DisplayPipelineSettings settings = null)
        {
            settings = settings ?? new DisplayPipelineSettings();
            var display = new DisplayPipeline(seed, settings);
            var load = settings.VerticesOf(renderMs);
            for (var frame = 0; frame < 50; frame++) display.Next(load);
            var all = Enumerable.Range(0, frames).Select(_ => display.Next(load)).ToArray();
            return all.Where((frame, i) => i + 1 == all.Length || !frame.IsReplacedBy(all[i + 1])).ToList();
        }

        static double[] LatenciesMs(IEnumerable<PipelineFrame> frames) => frames.Select(frame => frame.Visualisation.TotalMilliseconds).ToArray();

        static double Deviation(double[] values)
        {
            var mean = values.Average();
            return Math.Sqrt(values.Sum(value => (value - mean) * (value - mean)) / (values.Length - 1));
        }

        [Test]
        public void Next_RenderTimeAboveTheTrueLimit_LengthensTheConstantLatency()
        {
            Assert.That(VisualisationMs(4), Is.EqualTo(Steady.PlateauMs).Within(1e-4));
            Assert.That(VisualisationMs(TrueLimitMs - 0.01), Is.EqualTo(Steady.PlateauMs).Within(1e-4));
            Assert.That(VisualisationMs(TrueLimitMs + 0.01), Is.EqualTo(Steady.PlateauMs + Steady.RefreshMs).Within(1e-4));
            Assert.That(
                VisualisationMs(Steady.RefreshMs - 0.01), Is.EqualTo(Steady.PlateauMs + Steady.RefreshMs).Within(1e-4),
                "each frame misses the latch");
            Assert.That(VisualisationMs(18), Is.GreaterThan(Steady.PlateauMs + 18), "the queue is full");
            Assert.That(TrueLimitMs, Is.EqualTo(15.17).Within(0.01));
        }

        [TestCase(17)]
        [TestCase(20)]
        [TestCase(50)]
        public void Next_RenderTimeLongerThanARefreshInterval_StartsFramesOneRenderTimeApart(double renderMs)
        {
            var display = new DisplayPipeline(1, Steady);
            // The queue fills slowly when the render time is only a little longer than a refresh.
            for (var frame = 0; frame < 100; frame++) display.Next(Steady.VerticesOf(renderMs));

            for (var frame = 0; frame < 600; frame++)
            {
                var next = display.Next(Steady.VerticesOf(renderMs));

                Assert.That((display.NextStart - next.Start).TotalMilliseconds, Is.EqualTo(renderMs).Within(1e-3),
                    "the start is not rounded to refreshes");
                Assert.That((next.Done - next.Start).TotalMilliseconds, Is.EqualTo(2 * renderMs).Within(1e-3), "two frames are in progress");
            }
        }

        // A frame is done two render times after its start. Then it waits for a refresh; the duration of this wait is uniformly distributed.
        [TestCase(17.3)]
        [TestCase(21.1)]
        public void Next_RenderTimeLongerThanARefresh_LatencyIsUniformOverARefresh(double renderMs)
        {
            const int frames = 2000;
            var latencies = LatenciesMs(DisplayedFrames(renderMs, 1, frames, Steady));

            var min = Steady.PlateauMs + 2 * renderMs + DisplayPipelineSettings.LatchMs - Steady.RefreshMs;
            Assert.That(latencies, Has.Length.EqualTo(frames), "all frames are displayed");
            Assert.That(latencies, Has.All.InRange(min - 1e-3, min + Steady.RefreshMs + 1e-3));
            for (var tenth = 0; tenth < 10; tenth++)
            {
                var from = min + tenth * Steady.RefreshMs / 10;
                var count = latencies.Count(latency => latency >= from && latency < from + Steady.RefreshMs / 10);
                Assert.That(count, Is.EqualTo(frames / 10).Within(frames / 100));
            }
        }

        [Test]
        public void Next_RenderTimesVary_LatencyVariesOnlyOutsideTheConstantRange(
            [Values(6.5, 12)] double insideMs, [Values(17, 18, 21)] double beyondMs)
        {
            var settings = new DisplayPipelineSettings(spikeChance: 0);
            var evenScatterMs = settings.RefreshMs / Math.Sqrt(12);
            foreach (var seed in Enumerable.Range(1, 20))
            {
                var inside = Deviation(LatenciesMs(DisplayedFrames(insideMs, seed, 600, settings)));
                var beyond = Deviation(LatenciesMs(DisplayedFrames(beyondMs, seed, 600, settings)));

                Assert.That(inside, Is.LessThan(1e-3), "seed " + seed);
                Assert.That(beyond, Is.EqualTo(evenScatterMs).Within(25).Percent, "seed " + seed);
            }
        }

        [Test]
        public void Next_AnyLoad_KeepsFramesInOrderAndAtMostTwoInProgress([Values(1, 2, 3)] int seed)
        {
            var display = new DisplayPipeline(seed);
            var random = new Random(seed);
            var frames = new List<PipelineFrame>();
            var tick = TimeSpan.FromTicks(1);

            for (var i = 0; i < 5000; i++)
            {
                var due = display.NextStart;
                var frame = display.Next(2.5e6 * random.NextDouble());
                Assert.That(frame.Start, Is.EqualTo(due));
                Assert.That(frame.Done - frame.Start, Is.GreaterThanOrEqualTo(frame.RenderTime - tick));
                var shownMs = (frame.Start + frame.Visualisation).TotalMilliseconds - Steady.PlateauMs + Steady.RefreshMs;
                Assert.That(shownMs, Is.EqualTo(frame.Refresh * Steady.RefreshMs).Within(1e-3));
                var waitMs = shownMs - frame.Done.TotalMilliseconds;
                Assert.That(waitMs, Is.InRange(DisplayPipelineSettings.LatchMs - 1e-3, DisplayPipelineSettings.LatchMs + Steady.RefreshMs + 1e-3),
                    "the frame is shown at the first possible refresh");
                if (i >= 1)
                {
                    Assert.That(frame.Done - frames[i - 1].Done, Is.GreaterThanOrEqualTo(frame.RenderTime - tick),
                        "the GPU renders one frame at a time");
                    Assert.That(frame.Refresh, Is.GreaterThanOrEqualTo(frames[i - 1].Refresh));
                    Assert.That(RefreshOf(frame.Start), Is.GreaterThan(RefreshOf(frames[i - 1].Start)), "at most one frame starts for each refresh");
                }
                if (i >= 2) Assert.That(frame.Start, Is.GreaterThanOrEqualTo(frames[i - 2].Done), "at most two frames are in progress");
                frames.Add(frame);
            }
        }

        static int RefreshOf(TimeSpan start) => (int)Math.Floor(start.TotalMilliseconds / Steady.RefreshMs + 1e-5);

        [Test]
        public void Next_OneSlowFrame_DelaysOnlyTheNextFrames()
        {
            var display = new DisplayPipeline(1, Steady);
            display.Next(0);
            var slow = display.Next(Steady.VerticesOf(30));
            var behind = display.Next(0);
            var afterwards = display.Next(0);
            for (var frame = 0; frame < 2; frame++) display.Next(0);

            var later = display.Next(0);

            Assert.That(slow.Visualisation.TotalMilliseconds, Is.EqualTo(Steady.PlateauMs + Steady.RefreshMs).Within(1e-4));
            Assert.That(behind.Visualisation, Is.EqualTo(slow.Visualisation), "the next frame waited in the queue");
            Assert.That(behind.IsReplacedBy(afterwards), Is.True, "the next frame is finished for the same refresh");
            Assert.That(slow.IsReplacedBy(behind), Is.False);
            Assert.That(later.Visualisation.TotalMilliseconds, Is.EqualTo(Steady.PlateauMs).Within(1e-4));
        }

        [Test]
        public void Next_SameSeed_RepeatsScatterAndSlowFrames()
        {
            var (first, second) = (new DisplayPipeline(7), new DisplayPipeline(7));
            var (sum, squares, slow) = (0.0, 0.0, 0);
            const int frames = 20_000;
            for (var frame = 0; frame < frames; frame++)
            {
                var render = first.Next(1e6).RenderTime;
                Assert.That(second.Next(1e6).RenderTime, Is.EqualTo(render));
                var ratio = render.TotalMilliseconds / 12.5;
                if (ratio > 1.3) slow++;
                else (sum, squares) = (sum + ratio, squares + ratio * ratio);
            }

            var mean = sum / (frames - slow);
            Assert.That(mean, Is.EqualTo(1).Within(0.001));
            Assert.That(Math.Sqrt(squares / (frames - slow) - mean * mean), Is.EqualTo(0.03).Within(0.001));
            Assert.That(slow, Is.EqualTo(frames / 100).Within(45), "the number is within three standard deviations");
        }

        [TestCase(double.NaN)]
        [TestCase(-1)]
        public void Next_InvalidLoad_IsRefused(double vertices)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new DisplayPipeline(1).Next(vertices));
        }
    }
}
