using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Simulation;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Calibrate;

/// <summary>Render times of <see cref="RenderTimeSourceKind.GpuCompletion"/>: the engine checks once per frame whether a job is finished.</summary>
public class FrameResolutionTests
{
    const int NormalLoad = 300_000, NearlyFullLoad = 1_200_000, HighLoad = 1_800_000;

    // Returns, for each frame, its L_visu and the render time that became available at its start.
    static IEnumerable<(double VisuMs, double? RenderMs)> Frames(IEnumerable<int> loads, int lateFrames, double jitterMs, int seed)
    {
        var random = new Random(seed);
        var display = new DisplayPipeline(seed, new DisplayPipelineSettings(plateauMs: 40));
        var waiting = new Queue<(int Index, double TriggeredMs, double DoneMs)>();
        var index = 0;
        foreach (var load in loads)
        {
            var frame = display.Next(load);
            var startMs = frame.Start.TotalMilliseconds;
            var pollMs = startMs + 1 + 0.3 * jitterMs * random.NextNormal();
            double? renderMs = null;
            while (waiting.TryPeek(out var oldest) && oldest.Index + lateFrames < index && oldest.DoneMs <= pollMs)
                renderMs = pollMs - waiting.Dequeue().TriggeredMs;
            waiting.Enqueue((index++, startMs + 4 + jitterMs * random.NextNormal(), frame.Done.TotalMilliseconds));
            yield return (frame.Visualisation.TotalMilliseconds, renderMs);
        }
    }

    static double LimitOf(int lateFrames, double jitterMs, int seed)
    {
        var random = new Random(seed);
        var loads = Enumerable.Range(0, 11).Concat(Enumerable.Range(0, 10).Reverse()).SelectMany(step => Enumerable.Repeat(200_000 * step, 300));
        var pairs = Frames(loads, lateFrames, jitterMs, seed).Where(frame => frame.RenderMs.HasValue && random.NextDouble() < 0.33)
            .Select(frame => new LatencyPair(frame.RenderMs.Value, frame.VisuMs + 8 * (random.NextDouble() - 0.5))).ToArray();
        return RangeFit.Fit(pairs, new PairOrigin(RenderTimeSourceKind.GpuCompletion, new DisplayConditions())).LimitRenderMs.Value;
    }

    [Test]
    public void Fit_CompletionOnTheGpu_MonitorReturnsToTheRangeAfterALoad(
        [Values(0, 1, 2)] int lateFrames, [Values(0.2, 0.7)] double jitterMs, [Values(NormalLoad, NearlyFullLoad)] int usual,
        [Values(1, 2, 3)] int seed)
    {
        var limitMs = LimitOf(lateFrames, jitterMs, seed);
        var monitor = new ConstantLatencyMonitor(new ConstantLatencyRange(limitMs, RenderTimeSourceKind.GpuCompletion));
        IEnumerable<int> loads = [.. Enumerable.Repeat(usual, 600), .. Enumerable.Repeat(HighLoad, 120), .. Enumerable.Repeat(usual, 3600)];

        var states = Frames(loads, lateFrames, jitterMs, seed + 10).Select(frame =>
        {
            if (frame.RenderMs is double ms) monitor.Add(TimeSpan.FromMilliseconds(ms), RenderTimeSourceKind.GpuCompletion);
            return monitor.State;
        }).ToArray();

        int Count(Range frames, RangeState state) => states[frames].Count(each => each == state);
        Assert.That(Count(..600, RangeState.Outside), Is.Zero, $"frames outside before the load, limit {limitMs} ms");
        Assert.That(Count(630..720, RangeState.Outside), Is.EqualTo(90), $"frames outside during the load, limit {limitMs} ms");
        // Near the limit, several slow frames in succession make frames late, also without the high load.
        var minCount = usual == NormalLoad ? 3540 : 3240;
        Assert.That(Count(780.., RangeState.Inside), Is.GreaterThanOrEqualTo(minCount), $"frames inside after the load, limit {limitMs} ms");
    }
}
