using System.Text.Json.Serialization;
using Nowpose.Cli.Demo.Paper;

namespace Nowpose.Cli.Demo;

/// <summary>The measured results of a demo run, with the field names of result.json. Null means that nothing was measured.</summary>
sealed record DemoResult(
    double Seconds, int Frames, long Samples, long Dropped, string Network,
    DemoResult.Latencies LatencyMs, DemoResult.ClockErrors Clock, DemoResult.ToolErrors ToolErrorMm, DemoResult.FrameCost Frame,
    DemoResult.Hindcasts Hindcast, DemoResult.Ranges Range, DemoResult.LightErrors LightErrorMs, DemoResult.BodyErrors Bodies)
{
    /// <summary>The paper's claims with this run's numbers; null without <c>--paper</c>.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<PaperClaim> Claims { get; init; }

    /// <summary>Milliseconds. <see cref="Visu"/> is the simulated headset's true L_visu.</summary>
    public sealed record Latencies(double? AppP50, double? AppP95, double Visu, double? TotalErrorP95);

    /// <summary>Error of the end-to-end latency: magnitude of the assumed minus the true control time of the light, ms.</summary>
    public sealed record LightErrors(double? P50, double? P95, double? Max);

    /// <param name="StatedErrorUsP50">The runtime's estimated error. This and the next value are not in result.json, whose fields are fixed.</param>
    /// <param name="WithinStatedShare">Share of the time in which the true error was within the estimated error.</param>
    public sealed record ClockErrors(
        double? OffsetErrorUsP50, double? OffsetErrorUsP95, double? OffsetErrorUsMax, double? SkewErrorPpm, double? ConvergedS,
        [property: JsonIgnore] double? StatedErrorUsP50, [property: JsonIgnore] double? WithinStatedShare);

    /// <summary>Errors of the cell's objects while they move.</summary>
    public sealed record BodyErrors(PoseErrors ErrorMm, PoseErrors ErrorDeg);

    public sealed record PoseErrors(double? HoldRms, double? Rms, double? P95, double? Reduction);

    public sealed record ToolErrors(
        double? HoldRms, double? HoldMax, double? Rms, double? P95, double? Max,
        double? Reduction, double? ReductionFirstCycle, double? ReductionRepeated);

    /// <summary>The runtime's own measurement, without the truth. The uncertainty is half of the 95 % confidence interval.</summary>
    /// <param name="Withheld">Why the runtime gives no numbers; null if it gives them, or has none yet.</param>
    public sealed record Hindcasts(double? Reduction, double? ReductionUncertainty, double? RmsMm, double? HoldRmsMm, string Withheld)
    {
        /// <summary>The runtime's own reduction, or why there is none.</summary>
        [JsonIgnore]
        public string ReductionText => Withheld != null ? "withheld: " + Withheld
            : Reduction == null ? "–"
            : FormattableString.Invariant($"{100 * Reduction:0.0} ± {100 * ReductionUncertainty:0.0} %");
    }

    /// <summary>
    /// When the runtime detected that the constant-latency range was left and finally entered again, s since the start; the number of
    /// frames that it classified as outside, and the number of its alarms.
    /// </summary>
    public sealed record Ranges(double? LimitRenderMs, double? LeftS, double? FoundS, int FramesOutside, int Alarms);

    public sealed record FrameCost(double? CpuUsP50, double? CpuUsP99, double? AllocatedBytesPerFrame);
}
