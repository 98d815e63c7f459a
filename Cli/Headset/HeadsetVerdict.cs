using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Session;

namespace Nowpose.Cli.Headset;

/// <summary>Decides whether a run shows that a gateway and its plant are suitable.</summary>
static class HeadsetVerdict
{
    /// <summary>Minimum share of frames with a current pose.</summary>
    const double MinCurrentShare = 0.5;

    /// <summary>Gets the reason why a recording is incomplete, in one line; null if it is complete.</summary>
    /// <param name="problem">Reason why the recording ended early; null if it did not.</param>
    /// <param name="lostLines">Number of lines that the recording lost.</param>
    public static string RecordingFaultOf(string problem, long lostLines) => problem ?? (lostLines > 0 ? HeadsetMessages.LinesLost(lostLines) : null);

    /// <summary>Gets the reason why the run failed, in one line; null if it did not fail.</summary>
    /// <param name="statistics">Statistics at the end of the run.</param>
    /// <param name="wasTimeTrusted">Whether, at any time in the run, the clock was accurate enough for a current pose.</param>
    /// <param name="outages">
    /// Periods without a current pose. If no joint is missing, no connection has failed and the base is current at the end, the longest finished outage
    /// gives the reason.
    /// </param>
    /// <param name="baseFault">See <see cref="BaseFaultOf"/>.</param>
    public static string FailureOf(
        HeadsetResult.PoseResult pose, SessionStatistics statistics, bool wasTimeTrusted, IReadOnlyList<HeadsetResult.OutageResult> outages,
        string baseFault = null)
    {
        var share = pose.CurrentShareOfRun ?? 0;
        if (pose.CurrentAfterS != null && share >= MinCurrentShare) return null;
        if (!wasTimeTrusted) return HeadsetMessages.NoClock(statistics.SyncLink.Detail);
        if (statistics.OwnRobot.OtherNamespaces is { } fault) return HeadsetMessages.OtherNamespaces(fault);
        if (statistics.Samples == 0)
            return IsOtherRobot(statistics)
                ? HeadsetMessages.NoJointsOfRobot(RobotMessages.DescriptionDiffers)
                : HeadsetMessages.NoJoints(statistics.SampleLink.State == LinkState.Connected ? null : statistics.SampleLink.Detail);
        var joints = JointStatusText.Of(statistics.JointStatuses.Where(joint => joint.IsMissing));
        var why = joints.Length > 0 ? joints : LinkFaultOf(statistics) ?? baseFault ?? LongestOf(outages) ?? HeadsetMessages.AtEnd(pose.State);
        return pose.CurrentAfterS == null
            ? HeadsetMessages.NeverCurrent(why)
            : HeadsetMessages.RarelyCurrent(100 * share, 100 * MinCurrentShare, why);
    }

    /// <summary>Gets the reasons why the displayed pose may be wrong although it is current, in one line each.</summary>
    public static IEnumerable<string> NotesOf(SessionStatistics statistics)
    {
        if (IsOtherRobot(statistics)) yield return RobotMessages.DescriptionDiffers;
        if (statistics.BeyondLimits != null) yield return statistics.BeyondLimits.Words;
    }

    static bool IsOtherRobot(SessionStatistics statistics) => statistics.RobotDescriptionMatch == RobotDescriptionMatch.Different;

    /// <summary>
    /// Gets the known reason why a pose is not current: a failed connection, joints without data, or the moving base. The text contains no times.
    /// </summary>
    /// <param name="baseFault">See <see cref="BaseFaultOf"/>.</param>
    public static string ReasonOf(SessionStatistics statistics, IEnumerable<JointStatus> missing, string baseFault)
    {
        var joints = JointStatusText.Of(missing, joint => joint.DescriptionSince(null));
        return LinkFaultOf(statistics) ?? (joints.Length > 0 ? joints : baseFault ?? "");
    }

    /// <summary>Gets the reason why the moving base of the robot is not current; null if the base is not the reason for the state of the pose.</summary>
    public static string BaseFaultOf(CompensationSession session, HeadsetTime now)
    {
        var robot = session.Robots[0];
        if (!robot.Frame.IsLimitedByBase) return null;
        var fault = session.Cell.Faults(now).Objects.Where(part => part.Name == robot.Root).Select(part => part.Reason).FirstOrDefault();
        return fault == null ? null : HeadsetMessages.BaseNotCurrent(robot.Root, fault);
    }

    static string LongestOf(IReadOnlyList<HeadsetResult.OutageResult> outages) =>
        outages.Where(outage => outage is { ToS: not null, Reason.Length: > 0 }).MaxBy(outage => outage.ToS - outage.FromS) is { } longest
            ? HeadsetMessages.Outage(longest.FromS, longest.ToS, longest.Pose, longest.Reason) : null;

    static string LinkFaultOf(SessionStatistics statistics) =>
        statistics.SyncLink.State == LinkState.Waiting ? statistics.SyncLink.Detail
        : statistics.SampleLink.State == LinkState.Waiting ? statistics.SampleLink.Detail : null;
}
