using System.Globalization;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;

namespace Nowpose.Gateway.Status;

/// <summary>The state of the gateway and its plants as one line.</summary>
/// <param name="Level">ok, warning or error.</param>
/// <param name="SinceUtc">Start of the condition in the text; null if there is none.</param>
sealed record OverallStatus(string Level, string Text, string SinceUtc = null)
{
    /// <summary>Maximum number of objects and signals in the text.</summary>
    const int MaxNames = 3;

    /// <summary>Summarises the state.</summary>
    /// <param name="conditions">Current conditions, the worst first.</param>
    /// <param name="joints">States of all joints.</param>
    /// <param name="frames">States of all frames.</param>
    /// <param name="signals">States of all signals.</param>
    /// <param name="hasRobot">Whether a robot is described, so that joint positions must arrive.</param>
    /// <param name="headsets">Number of headsets that report.</param>
    public static OverallStatus Of(
        IReadOnlyList<Condition> conditions, IReadOnlyList<JointSnapshot> joints, IReadOnlyList<FrameView> frames, IReadOnlyList<SignalView> signals,
        bool hasRobot, int headsets)
    {
        if (conditions.Count == 0) return WithoutConditions(joints, frames, signals, hasRobot, $", {Count(headsets, "headset")}");
        var more = conditions.Count == 1 ? "" : $" (and {conditions.Count - 1} more)";
        var since = conditions[0].Since is { } start ? UtcText.Of(start) : null;
        return new(conditions[0].Level.ToString().ToLowerInvariant(), conditions[0].Text + more, since);
    }

    // Uses objects and signals for a cell without a robot. Stationary objects do not count, because they do not show that the plant sends data.
    static OverallStatus WithoutConditions(
        IReadOnlyList<JointSnapshot> joints, IReadOnlyList<FrameView> frames, IReadOnlyList<SignalView> signals, bool hasRobot, string headsets)
    {
        if (joints.Count > 0) return new("ok", Summary(joints) + headsets);
        var states = frames.Where(frame => frame.State != CellStates.Stationary).Select(frame => (frame.Name, frame.State)).ToArray();
        var all = states.Length + signals.Count;
        if (hasRobot || all == 0) return new("warning", JointReasons.NoSource);
        var others = states.Concat(signals.Select(signal => (signal.Name, signal.State))).Where(one => one.State != CellStates.Live).ToArray();
        return others.Length > 0
            ? new("warning", $"{others.Length} of {Count(all, "object or signal", "objects and signals")} {(others.Length == 1 ? "is" : "are")} not current: {List(others)}")
            : new("ok", $"{Count(states.Length, "object")}, {Count(signals.Count, "signal")}{headsets}");
    }

    static string Summary(IReadOnlyList<JointSnapshot> joints)
    {
        var resting = joints.Count(joint => joint.State == JointDataState.Rest);
        return resting == 0 ? $"{Count(joints.Count, "joint")} live" : JointReasons.Summary(Count(joints.Count - resting, "joint"), resting);
    }

    static string List((string Name, string State)[] others) =>
        string.Join(", ", others.Take(MaxNames).Select(one => $"{one.Name} ({one.State})")) + (others.Length > MaxNames ? ", …" : "");

    static string Count(int number, string noun, string plural = null) =>
        string.Create(CultureInfo.InvariantCulture, $"{number} {(number == 1 ? noun : plural ?? noun + "s")}");
}
