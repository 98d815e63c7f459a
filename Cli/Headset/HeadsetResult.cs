using System.Text.Json;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>The result of a headset run. Null stands for values that were never known. Written as JSON in snake case.</summary>
/// <param name="VersionMismatch">A sentence if the gateway's version does not fit; null if it fits or is unknown.</param>
sealed record HeadsetResult(
    double Seconds, int Frames, string Robot, long Samples, long Dropped,
    HeadsetResult.ClockResult Clock, HeadsetResult.LatencyResult LatencyMs, HeadsetResult.PoseResult Pose, HeadsetResult.ErrorResult ToolErrorMm,
    IReadOnlyList<string> MissingJoints, IReadOnlyList<HeadsetResult.JointResult> Joints, IReadOnlyList<HeadsetResult.StretchResult> Stretches,
    IReadOnlyList<HeadsetResult.OutageResult> Outages, string VersionMismatch)
{
    static readonly JsonSerializerOptions Options = new() { PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower, WriteIndented = true };

    /// <param name="CoarseAfterS">Time from the start to the first coarse state; the next value is for the synchronised state.</param>
    /// <param name="OffsetNs">Estimated Φ = C2 − C1 at <paramref name="AtNs"/>; C2 is this machine's monotonic counter.</param>
    /// <param name="EstimatedErrorUs">The stated uncertainty of the offset: its estimated maximum error in either direction, µs.</param>
    /// <param name="AtNs">C2 at the end of the run, ns.</param>
    public sealed record ClockResult(
        string State, double? ErrorBoundUs, double? SkewPpm, double? RttMs, int Steps, double? CoarseAfterS, double? SynchronisedAfterS,
        long? OffsetNs, double? EstimatedErrorUs, long AtNs);

    public sealed record LatencyResult(double? AppP50, double? AppP95, double Visu, double? EndToEnd);

    /// <param name="CurrentShare">Share of the frames since the first current one.</param>
    /// <param name="LongestNotCurrentS">The longest time without a current pose after the first one.</param>
    /// <param name="CurrentShareOfRun">Share of all frames, except those of the first 3 s before the first current one.</param>
    /// <param name="NotCurrentS">Total time without a current pose after the first one. Frames in it are not scored.</param>
    public sealed record PoseResult(
        string State, double? CurrentAfterS, double? CurrentShare, double LongestNotCurrentS, double? CurrentShareOfRun, double NotCurrentS);

    /// <summary>
    /// Errors of the current frames, from the samples that arrived later. They do not include the errors of the clock offset and of L_visu.
    /// </summary>
    public sealed record ErrorResult(double HoldRms, double HoldP95, double Rms, double P95, double? Reduction, double? ReductionUncertainty)
    {
        public static ErrorResult Of(DisplayedError? error) => error is not { } of
            ? null : new ErrorResult(of.HoldRms, of.HoldP95, of.Rms, of.P95, of.Reduction, of.ReductionUncertainty);
    }

    /// <summary>A joint that is not live at the end of the run.</summary>
    /// <param name="SinceS">Time for which it has been in this state, s.</param>
    public sealed record JointResult(string Name, string State, double? SinceS, string Reason)
    {
        public static JointResult Of(JointStatus joint) =>
            new(joint.Joint, JointDataStates.Of(joint.State), joint.Age?.TotalSeconds, joint.Reason);
    }

    /// <summary>A part of the run between two of its outages.</summary>
    /// <param name="FromS">First current frame, since the start.</param>
    /// <param name="ToS">Last current frame, since the start.</param>
    /// <param name="CurrentShare">Share of the frames between the two.</param>
    public sealed record StretchResult(double FromS, double ToS, double CurrentShare, ErrorResult ToolErrorMm);

    /// <summary>A time without a current pose, at the start or later.</summary>
    /// <param name="ToS">End of the outage; null if it lasted to the end of the run.</param>
    /// <param name="Pose">State of the pose at the end of the outage.</param>
    /// <param name="Joints">All joints that had no data during the outage, by name.</param>
    /// <param name="Reason">The first reasons in their order, separated by "; then "; empty while unknown.</param>
    public sealed record OutageResult(double FromS, double? ToS, string Pose, IReadOnlyList<string> Joints, string Reason);

    public string Json() => JsonSerializer.Serialize(this, Options);
}
