using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>The result of a headset run, written as JSON in snake case. A value is null if it was never known.</summary>
/// <param name="Robot">Name of the robot; null if the gateway did not describe it.</param>
/// <param name="OutagesNotListed">Number of further outages, none of which is longer than the finished ones in the list.</param>
/// <param name="ObjectsNotCurrent">Objects of the cell that are not current at the end of the run, apart from reasons that affect all of them.</param>
/// <param name="SignalsNotCurrent">The same for signals.</param>
/// <param name="ObjectsNotFollowed">Objects on robots that the session does not show. They are not among the objects that are not current.</param>
/// <param name="VersionMismatch">Message that the gateway's version is not compatible; null if it is compatible or unknown.</param>
sealed record HeadsetResult(
    double Seconds, int Frames, string Robot, long Samples, long Dropped,
    HeadsetResult.ClockResult Clock, HeadsetResult.LatencyResult LatencyMs, HeadsetResult.PoseResult Pose, HeadsetResult.ErrorResult ToolErrorMm,
    IReadOnlyList<string> MissingJoints, IReadOnlyList<HeadsetResult.JointResult> Joints, IReadOnlyList<HeadsetResult.StretchResult> Stretches,
    IReadOnlyList<HeadsetResult.OutageResult> Outages, int OutagesNotListed, IReadOnlyList<HeadsetResult.PartResult> ObjectsNotCurrent,
    IReadOnlyList<HeadsetResult.PartResult> SignalsNotCurrent, IReadOnlyList<HeadsetResult.OtherPartResult> ObjectsNotFollowed,
    string VersionMismatch)
{
    /// <param name="CoarseAfterS">Time from the start to the first coarse or synchronised state.</param>
    /// <param name="SynchronisedAfterS">Time from the start to the first synchronised state.</param>
    /// <param name="OffsetNs">Estimated Φ = C2 − C1 at <paramref name="AtNs"/>; C2 is this machine's monotonic counter.</param>
    /// <param name="EstimatedErrorUs">Estimated error of the offset in either direction, µs.</param>
    /// <param name="AtNs">C2 at the end of the run, ns.</param>
    public sealed record ClockResult(
        string State, double? ErrorBoundUs, double? SkewPpm, double? RttMs, int Steps, double? CoarseAfterS, double? SynchronisedAfterS,
        long? OffsetNs, double? EstimatedErrorUs, long AtNs);

    public sealed record LatencyResult(double? AppP50, double? AppP95, double Visu, double? EndToEnd);

    /// <param name="CurrentShare">Share of frames with a current pose, counted from the first current frame.</param>
    /// <param name="LongestNotCurrentS">Longest time without a current pose after the first current frame.</param>
    /// <param name="CurrentShareOfRun">Share of frames with a current pose in the whole run, from its first frame on.</param>
    /// <param name="NotCurrentS">Total time without a current pose after the first current frame. Frames in this time are not scored.</param>
    public sealed record PoseResult(
        string State, double? CurrentAfterS, double? CurrentShare, double LongestNotCurrentS, double? CurrentShareOfRun, double NotCurrentS);

    /// <summary>
    /// Errors of the frames with a current pose, computed from samples that arrived later. They exclude the errors of clock offset and L_visu.
    /// </summary>
    public sealed record ErrorResult(double HoldRms, double HoldP95, double Rms, double P95, double? Reduction, double? ReductionUncertainty)
    {
        public static ErrorResult Of(DisplayedError? error) => error is not { } of
            ? null : new ErrorResult(of.HoldRms, of.HoldP95, of.Rms, of.P95, of.Reduction, of.ReductionUncertainty);
    }

    /// <summary>A joint whose state is not live at the end of the run.</summary>
    /// <param name="SinceS">Time for which the joint has been in this state, s.</param>
    public sealed record JointResult(string Name, string State, double? SinceS, string Reason)
    {
        public static JointResult Of(JointStatus joint) =>
            new(joint.Joint, JointDataStates.Of(joint.State), joint.Age?.TotalSeconds, joint.Reason);
    }

    /// <summary>An object or a signal that is not current at the end of the run.</summary>
    /// <param name="SinceS">Time for which it has not been current, s.</param>
    public sealed record PartResult(string Name, double? SinceS, string Reason);

    /// <summary>An object on a robot that the session does not show.</summary>
    /// <param name="Link">Link of this robot, with its namespace.</param>
    public sealed record OtherPartResult(string Name, string Link);

    /// <summary>A part of the run between two outages.</summary>
    /// <param name="FromS">Time of the first current frame since the start of the run.</param>
    /// <param name="ToS">Time of the last current frame since the start of the run.</param>
    /// <param name="CurrentShare">Share of frames with a current pose between these two frames.</param>
    public sealed record StretchResult(double FromS, double ToS, double CurrentShare, ErrorResult ToolErrorMm);

    /// <summary>A period without a current pose. The period before the first current pose is included.</summary>
    /// <param name="ToS">End of the outage; null if it lasted until the end of the run.</param>
    /// <param name="Pose">State of the pose at the end of the outage.</param>
    /// <param name="Joints">Names of all joints that had no data during the outage, sorted.</param>
    /// <param name="Reason">The first reasons in the order in which they occurred, separated by "; then "; empty if unknown.</param>
    public sealed record OutageResult(double FromS, double? ToS, string Pose, IReadOnlyList<string> Joints, string Reason);

    public string Json() => JsonText.Of(this);
}
