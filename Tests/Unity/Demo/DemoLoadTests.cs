using System.Text.Json;
using Nowpose.Cli;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Messages;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using NUnit.Framework;
using static System.FormattableString;

namespace Nowpose.Unity.Tests.Demo;

/// <summary>Tests Fig. 10 of the paper in the demo: only a load that delays frames raises the alarm and the error.</summary>
public class DemoLoadTests
{
    [Test]
    public void Demo_LoadBeyondTheLimit_RaisesOneAlarm([Values(1, 2, 3)] int seed)
    {
        var run = LoadedDemo.Play(1_500_000, seed);

        var score = new DemoScore(run);
        var result = score.Result();
        var range = result.Range;
        Assert.That(run.Failure(), Is.Null);
        Assert.That(
            JsonDocument.Parse(JsonText.Of(result)).RootElement.GetProperty("range").EnumerateObject().Select(property => property.Name),
            Is.EqualTo(new[] { "limit_render_ms", "left_s", "found_s", "frames_outside", "alarms" }));
        Assert.That(
            string.Join('\n', DemoFacts.Range(run.Settings, result.Range, score.Range).Select(row => row.Value)),
            Does.Contain(DemoTexts.Alarm(Invariant($"{range.LeftS:0.0}"), DemoTexts.FoundAgain(Invariant($"{range.FoundS:0.0}")), alarms: 1)));
        Assert.That(range.Alarms, Is.EqualTo(1));
        Assert.That(range.LeftS, Is.InRange(6.67, 7.0), "the load starts at 6.67 s");
        Assert.That(range.FoundS, Is.InRange(15, 16), "the load ends at 15 s");
        Assert.That(
            score.Range.VisualisationMs(isOutside: true), Is.GreaterThan(score.Range.VisualisationMs(isOutside: false) + 15), "frames miss a refresh");
        Assert.That(score.Result().Hindcast.Reduction, Is.Null, "the headset cannot measure when these frames appear");
        Assert.That(score.Result().Hindcast.ReductionText, Does.StartWith("withheld"));
        Assert.That(score.Range.RmsOutsideMm, Is.GreaterThan(1.5 * score.Range.RmsInTimeMm.Value), "the error is larger than for the same frames shown in time");
        Assert.That(WhileLoaded(score, run), Is.GreaterThan(1.5 * WhileLoaded(seed)), "than the same motion without a load");
    }

    [Test]
    public void Demo_ProfileFromAFile_ReplacesTheCalibration()
    {
        var profile = new LatencyProfile(
            60, 1, "another headset", DemoDisplay.FramesPerSecond, DateTime.UtcNow, CalibrationMethod.VisibleLight, 10, 10.5,
            RenderTimeSourceKind.DisplayGpuTime);

        var run = LoadedDemo.Play(300_000, 1, 6, profile);
        var own = LoadedDemo.Play(300_000, 1, 6);

        Assert.That(run.Statistics.VisualisationLatency.TotalMilliseconds, Is.EqualTo(60));
        Assert.That(run.Limit, Is.EqualTo(TimeSpan.FromMilliseconds(10.5)));
        Assert.That(new DemoScore(run).Result().ToolErrorMm.Rms, Is.GreaterThan(1.5 * new DemoScore(own).Result().ToolErrorMm.Rms), "20 ms too much");
    }

    [Test]
    public void Demo_LoadBeyondTheMeasuredRangeOfAProfile_WithholdsTheErrorReduction()
    {
        var profile = new LatencyProfile(
            40, 1, "another headset", DemoDisplay.FramesPerSecond, DateTime.UtcNow, CalibrationMethod.VisibleLight, 10, null,
            RenderTimeSourceKind.DisplayGpuTime, 10);

        var result = new DemoScore(LoadedDemo.Play(1_500_000, 1, 12, profile)).Result();

        Assert.That(result.Range.Alarms, Is.Zero, "without a limit there is no alarm");
        Assert.That((result.Hindcast.Reduction, result.Hindcast.Withheld), Is.EqualTo(((double?)null, StateNames.BeyondMeasured)));
    }

    [Test]
    public void Demo_LoadThatMissesRefreshesWithoutARangeInTheProfile_WithholdsTheErrorReduction()
    {
        var profile = new LatencyProfile(
            40, 1, "another headset", 0, DateTime.UtcNow, CalibrationMethod.VisibleLight, 10, null, RenderTimeSourceKind.None);

        var result = new DemoScore(LoadedDemo.Play(1_500_000, 1, 12, profile)).Result();

        Assert.That((result.Hindcast.Reduction, result.Hindcast.Withheld), Is.EqualTo(((double?)null, StateNames.FramesMissRefreshes)));
    }

    [Test]
    public void Demo_LoadWithinTheLimit_RaisesNeitherAlarmNorError([Values(1, 2, 3)] int seed)
    {
        var run = LoadedDemo.Play(300_000, seed);

        var score = new DemoScore(run);
        var range = score.Result().Range;
        Assert.That(run.Failure(), Is.Null);
        Assert.That((range.Alarms, range.FramesOutside, range.LeftS), Is.EqualTo((0, 0, (double?)null)));
        Assert.That(range.LimitRenderMs, Is.Not.Null, "the range was monitored");
        Assert.That(score.Result().Hindcast.Reduction, Is.EqualTo(score.Result().ToolErrorMm.Reduction).Within(0.02), "the headset's own number");
        Assert.That(run.Frames.Rows[^1].Range, Is.EqualTo(RangeState.Inside));
        Assert.That(WhileLoaded(score, run), Is.EqualTo(WhileLoaded(seed)).Within(10).Percent, "of the same motion without a load");
    }

    [Test]
    public void Demo_LateFrames_AreReportedWithTheirDelay()
    {
        var frames = new DemoFrames(0, 4);
        foreach (var (second, delayMs) in new[] { (2.0, 90), (3.5, 9), (4.0, 8), (4.5, 41) })
            frames.Add([], [], new DemoFrames.Row { Elapsed = TimeSpan.FromSeconds(second), Delay = TimeSpan.FromMilliseconds(delayMs) });

        Assert.That(frames.Late(), Is.EqualTo(new LateFrames(2, 3, 41)));
        Assert.That(frames.Late().AreMany, Is.True);
    }

    [TestCase(1)]
    [TestCase(0)]
    public void Demo_FewLateFrames_AreNotReported(int late)
    {
        var frames = new DemoFrames(0, 200);
        for (var i = 0; i < 200; i++)
            frames.Add([], [], new DemoFrames.Row { Elapsed = TimeSpan.FromSeconds(4), Delay = TimeSpan.FromMilliseconds(i < late ? 50 : 1) });

        Assert.That((frames.Late().Count, frames.Late().AreMany), Is.EqualTo((late, false)));
    }

    static double WhileLoaded(int seed)
    {
        var run = LoadedDemo.Play(null, seed);
        return WhileLoaded(new DemoScore(run), run);
    }

    /// <summary>Returns the RMS error of the tool in mm while the load is present.</summary>
    static double WhileLoaded(DemoScore score, DemoRun run)
    {
        var load = new DemoLoad(1, run.Settings.Seconds);
        return Math.Sqrt(score.Errors.Where(e => load.VerticesAt(run.Frames.Rows[e.Frame].Elapsed) > 0).Average(e => e.Mm * e.Mm));
    }
}
