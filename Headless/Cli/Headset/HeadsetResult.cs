using System.Text.Json;

namespace Nowpose.Cli.Headset;

/// <summary>How a headset did; null stands for what it never came to know. Written as JSON in snake case.</summary>
sealed record HeadsetResult(
    double Seconds, int Frames, string Robot, long Samples, long Dropped,
    HeadsetResult.ClockResult Clock, HeadsetResult.LatencyResult LatencyMs, HeadsetResult.PoseResult Pose, HeadsetResult.ErrorResult ToolErrorMm)
{
    static readonly JsonSerializerOptions Options = new() { PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower, WriteIndented = true };

    /// <param name="SynchronisedAfterS">From the start.</param>
    public sealed record ClockResult(
        string State, double? ErrorBoundUs, double? SkewPpm, double? RttMs, int Steps, double? SynchronisedAfterS);

    public sealed record LatencyResult(double? AppP50, double? AppP95, double Visu, double? EndToEnd);

    /// <param name="CurrentShare">Of the frames since the first current one.</param>
    /// <param name="LongestNotCurrentS">The longest time without a current pose after the first one.</param>
    public sealed record PoseResult(string State, double? CurrentAfterS, double? CurrentShare, double LongestNotCurrentS);

    /// <summary>As the samples that came later tell; not the errors that these cannot see, of clock offset and L_visu.</summary>
    public sealed record ErrorResult(double HoldRms, double HoldP95, double Rms, double P95, double? Reduction, double? ReductionUncertainty);

    public string Json() => JsonSerializer.Serialize(this, Options);
}
