using System.Globalization;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>The state of the gateway and its plants in one line.</summary>
/// <param name="Level">ok, warning or error.</param>
sealed record OverallStatus(string Level, string Text)
{
    /// <param name="conditions">Present conditions, the worst first.</param>
    public static OverallStatus Of(
        IReadOnlyList<Condition> conditions, IReadOnlyList<JointStatus> joints,
        IReadOnlyList<(string Name, TimeSpan, IReadOnlyList<KeyValuePair<string, string>>)> reports)
    {
        if (conditions.Count == 0 && joints.Count == 0) return new("warning", "no source publishes joint positions yet");
        if (conditions.Count == 0) return new("ok", Summary(joints, reports.Count(one => !StatusObjects.IsAdapter(one.Name))));
        var more = conditions.Count == 1 ? "" : $" (and {conditions.Count - 1} more)";
        return new(conditions[0].Level.ToString().ToLowerInvariant(), conditions[0].TextWithSince + more);
    }

    static string Summary(IReadOnlyList<JointStatus> joints, int headsets)
    {
        var resting = joints.Count(joint => joint.State == JointDataState.Rest);
        var live = resting == 0 ? $"{Count(joints.Count, "joint")} live" : $"{Count(joints.Count - resting, "joint")} live, {resting} assumed at rest";
        return $"{live}, {Count(headsets, "headset")}";
    }

    static string Count(int number, string noun) => string.Create(CultureInfo.InvariantCulture, $"{number} {noun}{(number == 1 ? "" : "s")}");
}
