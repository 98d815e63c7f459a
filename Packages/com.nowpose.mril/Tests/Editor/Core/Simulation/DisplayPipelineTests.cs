using System;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Simulation
{
    public class DisplayPipelineTests
    {
        static readonly DisplayPipelineSettings Steady = new DisplayPipelineSettings(scatter: 0, spikeChance: 0);

        static readonly double TrueLimitMs = new DisplayPipeline(1).TrueLimit.TotalMilliseconds;

        static PipelineFrame FiftiethFrame(double renderMs, DisplayPipelineSettings settings)
        {
            var display = new DisplayPipeline(1, settings);
            for (var frame = 0; frame < 49; frame++) display.Next(settings.VerticesOf(renderMs));
            return display.Next(settings.VerticesOf(renderMs));
        }

        static double VisualisationMs(double renderMs) => FiftiethFrame(renderMs, Steady).Visualisation.TotalMilliseconds;

        [Test]
        public void Next_UpToTheTrueLimit_HasConstantLatencyAndALongerOneBeyond()
        {
            Assert.That(VisualisationMs(4), Is.EqualTo(Steady.PlateauMs).Within(1e-4));
            Assert.That(VisualisationMs(TrueLimitMs - 0.01), Is.EqualTo(Steady.PlateauMs).Within(1e-4));
            Assert.That(VisualisationMs(TrueLimitMs + 0.01), Is.EqualTo(Steady.PlateauMs + Steady.RefreshMs).Within(1e-4));
            Assert.That(VisualisationMs(18), Is.GreaterThan(Steady.PlateauMs + 1.5 * Steady.RefreshMs), "the queue is full");
            Assert.That(TrueLimitMs, Is.EqualTo(15.17).Within(0.01));
        }

        [Test]
        public void Next_GpuSlowerThanTheDisplay_DelaysFrameStarts()
        {
            const double renderMs = 20;
            var display = new DisplayPipeline(1, Steady);
            for (var frame = 0; frame < 600; frame++) display.Next(Steady.VerticesOf(renderMs));

            var last = display.Next(Steady.VerticesOf(renderMs));

            Assert.That(last.Start.TotalMilliseconds, Is.EqualTo(600 * renderMs).Within(3 * renderMs));
            Assert.That(last.Done - last.Start, Is.LessThanOrEqualTo(TimeSpan.FromTicks(2 * last.RenderTime.Ticks + 1)), "two under way");
            Assert.That(display.NextStart, Is.GreaterThan(last.Start));
        }

        [Test]
        public void Next_OneSlowFrame_DelaysOnlyTheNextFrames()
        {
            var display = new DisplayPipeline(1, Steady);
            display.Next(0);
            var slow = display.Next(Steady.VerticesOf(30));
            var behind = display.Next(0);
            for (var frame = 0; frame < 3; frame++) display.Next(0);

            var later = display.Next(0);

            Assert.That(slow.Visualisation.TotalMilliseconds, Is.EqualTo(Steady.PlateauMs + Steady.RefreshMs).Within(1e-4));
            Assert.That(behind.Visualisation, Is.EqualTo(slow.Visualisation), "it waited in the queue");
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
            Assert.That(slow, Is.EqualTo(frames / 100).Within(45), "three sigma");
        }

        [TestCase(double.NaN)]
        [TestCase(-1)]
        public void Next_InvalidLoad_IsRefused(double vertices)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => new DisplayPipeline(1).Next(vertices));
        }

        [Test]
        public void DisplayPipelineSettings_PlateauShorterThanARefresh_ThrowsWithTheRange()
        {
            Assert.That(
                Assert.Throws<InputException>(() => new DisplayPipelineSettings(refreshMs: 20, plateauMs: 10)).Message,
                Is.EqualTo("visualisation latency of frames in time: 10 ms is out of range; allowed are 20 to 500 ms"));
        }
    }
}
