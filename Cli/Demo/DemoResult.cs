using System.Text.Json.Serialization;
using Nowpose.Cli.Demo.Paper;

namespace Nowpose.Cli.Demo;

/// <summary>The results of a demo run, with the field names of result.json. A value is null if it was not measured.</summary>
sealed record DemoResult(
    double Seconds, int Frames, long Samples, long Dropped, string Network,
    DemoResult.Latencies LatencyMs, DemoResult.ClockErrors Clock, DemoResult.ToolErrors ToolErrorMm, DemoResult.FrameCost Frame,
    DemoResult.Hindcasts Hindcast, DemoResult.Ranges Range, DemoResult.LightErrors LightErrorMs, DemoResult.BodyErrors Bodies)
{
    /// <summary>Number of scored frames.</summary>
    public int FramesScored { get; init; }

    /// <summary>Number of frames after the warm-up that this machine started late.</summary>
    public int FramesLate { get; init; }

    /// <summary>The conditions of the run. With <c>--repeats</c>, those of the first repeat.</summary>
    public DemoConditions Conditions { get; init; }

    /// <summary>The paper's claims with the values of this run; null without <c>--paper</c>.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<PaperClaim> Claims { get; init; }

    /// <summary>The figures of all repeats; null for one run.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public DemoRepeats Repeats { get; init; }

    /// <summary>Reasons why the results can mislead a reader, in one line each; null if there are none.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<string> Notes { get; init; }

    /// <summary>Latencies in milliseconds. <see cref="Visu"/> is the simulated headset's true L_visu.</summary>
    public sealed record Latencies(double? AppP50, double? AppP95, double Visu, double? TotalErrorP95);

    /// <summary>Error of the end-to-end latency, ms: absolute difference between assumed and true display time.</summary>
    public sealed record LightErrors(double? P50, double? P95, double? Max);

    /// <param name="StatedErrorUsP50">
    /// The runtime's estimated error, µs. Not in result.json, whose fields are fixed; the same applies to the next parameter.
    /// </param>
    /// <param name="WithinStatedShare">Share of the time in which the true error was smaller than the estimated error.</param>
    public sealed record ClockErrors(
        double? OffsetErrorUsP50, double? OffsetErrorUsP95, double? OffsetErrorUsMax, double? SkewErrorPpm, double? ConvergedS,
        [property: JsonIgnore] double? StatedErrorUsP50, [property: JsonIgnore] double? WithinStatedShare);

    /// <summary>Errors of the cell's objects while they move.</summary>
    /// <param name="LargestSlipMm">
    /// Largest distance between a gripped object and its place in the displayed gripper, mm; null if none was gripped. It includes the frames in which the
    /// object is displayed as gripped, and those in which the gripper truly carries it.
    /// </param>
    public sealed record BodyErrors(PoseErrors ErrorMm, PoseErrors ErrorDeg, double? LargestSlipMm);

    public sealed record PoseErrors(double? HoldRms, double? Rms, double? P95, double? Reduction);

    public sealed record ToolErrors(
        double? HoldRms, double? HoldMax, double? Rms, double? P95, double? Max,
        double? Reduction, double? ReductionFirstCycle, double? ReductionRepeated);

    /// <summary>The runtime's own measurement, which does not use the true motion. Uncertainties are half of the 95 % confidence interval.</summary>
    /// <param name="Withheld">
    /// Reason why the runtime withholds its values; null if it does not withhold them. Also null before the first values exist.
    /// </param>
    public sealed record Hindcasts(double? Reduction, double? ReductionUncertainty, double? RmsMm, double? HoldRmsMm, string Withheld)
    {
        /// <summary>The reduction measured by the runtime, or the reason why it is missing.</summary>
        [JsonIgnore]
        public string ReductionText => Withheld != null ? "withheld: " + Withheld
            : Reduction == null ? "–"
            : ReductionUncertainty == null ? FormattableString.Invariant($"{100 * Reduction:0.0} % ± –")
            : FormattableString.Invariant($"{100 * Reduction:0.0} ± {100 * ReductionUncertainty:0.0} %");
    }

    /// <summary>The runtime's range state in a run under load. Times are in s since the start of the run.</summary>
    /// <param name="LeftS">Time of the first frame that the runtime considers outside the constant-latency range; null if there is none.</param>
    /// <param name="FoundS">Time of the first frame after the last one outside the range; null if there is none.</param>
    /// <param name="FramesOutside">Number of frames outside the range.</param>
    public sealed record Ranges(double? LimitRenderMs, double? LeftS, double? FoundS, int FramesOutside, int Alarms);

    public sealed record FrameCost(double? CpuUsP50, double? CpuUsP99, double? AllocatedBytesPerFrame);
}
