using System.Text.Json.Serialization;

namespace Nowpose.Cli.Demo;

/// <summary>What a demo run measured, in the words of result.json. Null stands for "nothing was measured".</summary>
sealed record DemoResult(
    double Seconds, int Frames, long Samples, long Dropped, string Network,
    DemoResult.Latencies LatencyMs, DemoResult.ClockErrors Clock, DemoResult.ToolErrors ToolErrorMm, DemoResult.FrameCost Frame,
    DemoResult.Hindcasts Hindcast, DemoResult.Ranges Range)
{
    /// <summary>Milliseconds; <see cref="Visu"/> is the simulated headset's true one.</summary>
    public sealed record Latencies(double? AppP50, double? AppP95, double Visu, double? TotalErrorP95);

    /// <param name="StatedErrorUsP50">The ± that the runtime states. For table and report; result.json has a fixed set of fields, likewise the next.</param>
    /// <param name="WithinStatedShare">Part of the time in which the true error was within the ±.</param>
    public sealed record ClockErrors(
        double? OffsetErrorUsP50, double? OffsetErrorUsP95, double? OffsetErrorUsMax, double? SkewErrorPpm, double? ConvergedS,
        [property: JsonIgnore] double? StatedErrorUsP50, [property: JsonIgnore] double? WithinStatedShare);

    public sealed record ToolErrors(
        double? HoldRms, double? HoldMax, double? Rms, double? P95, double? Max,
        double? Reduction, double? ReductionFirstCycle, double? ReductionRepeated);

    /// <summary>What the runtime itself measured, without the truth; its uncertainty is half of the 95 % confidence interval.</summary>
    public sealed record Hindcasts(double? Reduction, double? ReductionUncertainty, double? RmsMm, double? HoldRmsMm);

    /// <summary>
    /// When the runtime saw the constant-latency range left and, for good, found again, s since the start; how many frames it
    /// took for outside, and how often it said so.
    /// </summary>
    public sealed record Ranges(double? LimitRenderMs, double? LeftS, double? FoundS, int FramesOutside, int Alarms);

    public sealed record FrameCost(double? CpuUsP50, double? CpuUsP99, double? AllocatedBytesPerFrame);
}
