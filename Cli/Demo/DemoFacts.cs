using System.Globalization;
using static Nowpose.Cli.Messages.RunTexts;

namespace Nowpose.Cli.Demo;

/// <summary>Lists the settings and the results of a run with their labels, for the console and the report.</summary>
static class DemoFacts
{
    public static IEnumerable<(string Label, string Value)> Settings(DemoSettings s) =>
    [
        (DemoTexts.Robot, s.Robot.Name),
        (DemoTexts.Motion, s.MotionName),
        (DemoTexts.Network, s.Network.Name),
        (DemoTexts.Predictor, s.Predictor),
        (DemoTexts.Estimator, s.Estimator),
        (DemoTexts.SamplingInterval, Number(s.SamplingMs, "0.###", " ms")),
        (DemoTexts.Acquisition, s.Acquisition + " ms"),
        DisplayLatency(s),
        (DemoTexts.FrameRateLabel, !s.IsRendered ? DemoTexts.Fps(DemoDisplay.FramesPerSecond) : DemoTexts.FrameRate(DemoDisplay.FramesPerSecond)),
        (DemoTexts.Load, (s.Load ?? s.SteadyVertices) is int vertices ? DemoTexts.Vertices(vertices) : DemoTexts.None),
        (DemoTexts.SetPoints, s.PublishesPlan ? DemoTexts.Published : DemoTexts.None),
        .. Time(s),
        (DemoTexts.Version, ProgramVersion.Text),
        (DemoTexts.Seed, s.Seed.ToString(CultureInfo.InvariantCulture)),
    ];

    public static (string Label, string Value) DisplayLatency(DemoSettings s) => (
        DemoTexts.DisplayLatency,
        DemoTexts.GivenLatency(Number(s.VisualisationMs, "0.###", " ms"), Number(s.GivenVisualisationMs, "0.###", " ms")));

    /// <summary>Describes virtual time; no facts in real time.</summary>
    public static IEnumerable<(string Label, string Value)> Time(DemoSettings s) => s.IsVirtual ? [(DemoTexts.Time, DemoTexts.VirtualTime)] : [];

    public static IEnumerable<(string Label, string Value)> Results(DemoRun run, DemoScore score, DemoResult result) =>
    [
        (DemoTexts.MeasuredReduction, Reduction(result.Hindcast)),
        (DemoTexts.ApplicationLatency, $"{Ms(result.LatencyMs.AppP50)}, {Ms(result.LatencyMs.AppP95)}"),
        (DemoTexts.DisplayTimeError, Ms(result.LatencyMs.TotalErrorP95)),
        .. Workpieces(result.Bodies),
        .. Range(run.Settings, result.Range, score.Range),
        (DemoTexts.ClockError, $"{Us(result.Clock.OffsetErrorUsP50)}, {Us(result.Clock.OffsetErrorUsP95)}"),
        (DemoTexts.MaxClockError, Us(result.Clock.OffsetErrorUsMax)),
        (DemoTexts.EstimatedClockError,
            DemoTexts.EstimatedClockErrorValue(Us(result.Clock.StatedErrorUsP50), Percent(result.Clock.WithinStatedShare))),
        (DemoTexts.SynchronisedAfter, Number(result.Clock.ConvergedS, "0.0", " s")),
        .. FrameCost(run.Settings, result.Frame),
        (DemoTexts.Counts, Counts(result.Frames, result.Samples, result.Dropped)),
    ];

    /// <summary>Describes the constant-latency range; no facts without a load.</summary>
    public static IEnumerable<(string Label, string Value)> Range(DemoSettings settings, DemoResult.Ranges seen, DemoRange range)
    {
        if (seen == null) yield break;
        var load = new DemoLoad(settings.Load.Value, settings.Seconds);
        yield return (DemoTexts.RenderLoadRow, DemoTexts.RenderLoad(load.Vertices, load.FromSeconds, load.ToSeconds));
        yield return (DemoTexts.RangeRow, seen.LimitRenderMs == null ? DemoTexts.NoLimit : DemoTexts.Range(Number(seen.LimitRenderMs, "0.0#"), Alarm(seen)));
        if (seen.FramesOutside > 0)
            yield return (DemoTexts.FramesOutside(seen.FramesOutside), DemoTexts.Outside(
                Number(range.VisualisationMs(true), "0.0#"), Number(range.VisualisationMs(false), "0.0#"),
                Number(range.RmsOutsideMm, "0.00"), Number(range.RmsInTimeMm, "0.00")));
    }

    // No facts in virtual time, in which the cost of a frame is not measured.
    static IEnumerable<(string Label, string Value)> FrameCost(DemoSettings settings, DemoResult.FrameCost frame) => settings.IsVirtual ? [] :
    [
        (DemoTexts.FrameDuration, $"{Us(frame.CpuUsP50)}, {Us(frame.CpuUsP99)}"),
        (DemoTexts.AllocatedPerFrame, Number(frame.AllocatedBytesPerFrame, "0.##", " B")),
    ];

    // No facts if the cell has no objects.
    static IEnumerable<(string Label, string Value)> Workpieces(DemoResult.BodyErrors bodies)
    {
        if (bodies == null) yield break;
        yield return (DemoTexts.MovingWorkpieces, Errors(bodies.ErrorMm, " mm"));
        yield return (DemoTexts.RotatingWorkpieces, Errors(bodies.ErrorDeg, "°"));
        yield return (DemoTexts.LargestSlip, Mm(bodies.LargestSlipMm));
    }

    static string Errors(DemoResult.PoseErrors error, string unit) => DemoTexts.RmsWithReduction(
        Number(error.HoldRms, "0.00", unit), Number(error.Rms, "0.00", unit), Percent(error.Reduction));

    static string Alarm(DemoResult.Ranges seen)
    {
        if (seen.LeftS == null) return DemoTexts.NeverLeft;
        var found = seen.FoundS == null ? DemoTexts.NotFoundAgain : DemoTexts.FoundAgain(Number(seen.FoundS, "0.0"));
        return DemoTexts.Alarm(Number(seen.LeftS, "0.0"), found, seen.Alarms);
    }

    static string Reduction(DemoResult.Hindcasts measured) => measured.ReductionText
        + (measured.Withheld != null ? "" : ", " + DemoTexts.RmsFromTo(Mm(measured.HoldRmsMm), Mm(measured.RmsMm)));

    static string Mm(double? value) => Number(value, "0.00", " mm");
    static string Ms(double? value) => Number(value, "0.0#", " ms");
    static string Us(double? value) => Number(value, "0.#", " µs");
    static string Percent(double? share) => Number(100 * share, "0.0", " %");
}
