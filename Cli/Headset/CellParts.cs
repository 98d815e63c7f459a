using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Session.Cell;

namespace Nowpose.Cli.Headset;

/// <summary>
/// Follows all objects and signals that a session receives, except objects on other robots, which the session does not show, and lists those that are
/// not current.
/// </summary>
sealed class CellParts
{
    /// <summary>Time after its last pose for which an object that is not followed is listed.</summary>
    static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(10);

    readonly CompensationSession _session;
    readonly Dictionary<string, (string Parent, bool IsStationary, HeadsetTime Arrival)> _parents = new(StringComparer.Ordinal);
    readonly HashSet<string> _followed = new(StringComparer.Ordinal);
    bool _isChanged;

    public CellParts(CompensationSession session)
    {
        _session = session;
        session.Frames.Judged += OnPose;
        session.Signals.NeedAll();
    }

    /// <summary>Predicts the objects that have arrived for the first time. Call it after each frame, because the session calls the handler within one.</summary>
    public void Update()
    {
        if (!_isChanged) return;
        _isChanged = false;
        foreach (var name in _parents.Keys.ToArray())
        {
            var isFollowed = !_session.Frames.Tree.IsLink(name) && OtherRobotBelow(name) == null;
            if (isFollowed && _followed.Add(name)) _session.Frames.Need(name);
            else if (!isFollowed && _followed.Remove(name)) _session.Frames.Leave(name);
        }
    }

    /// <summary>Gets the objects and the signals that are not current, as the diagnostics list them.</summary>
    public (HeadsetResult.PartResult[] Objects, HeadsetResult.PartResult[] Signals) NotCurrent(HeadsetTime now)
    {
        var faults = _session.Cell.Faults(now);
        return (Results(faults.Objects), Results(faults.Signals));
    }

    /// <summary>Gets the objects on links of robots that the session does not show, or on unknown frames with the name of such a link.</summary>
    public HeadsetResult.OtherPartResult[] NotFollowed() =>
    [
        .. from name in _parents.Keys
           let link = OtherRobotBelow(name)
           where link != null
           select new HeadsetResult.OtherPartResult(name, link),
    ];

    // Returns the link of another robot on which an object is, also on other objects; null if there is none.
    string OtherRobotBelow(string name)
    {
        // The steps are limited, because poses that the session has not checked against each other can form a cycle.
        for (var steps = 0; steps <= _parents.Count && _parents.TryGetValue(name, out var known); steps++) name = known.Parent;
        var slash = name.IndexOf('/');
        return slash > 0 && RobotTopic.IsNamespace(name.AsSpan(0, slash)) && _session.Robots.Of(name[..slash]) == null ? name : null;
    }

    static HeadsetResult.PartResult[] Results(IReadOnlyList<PartStatus> parts) =>
        [.. parts.Select(part => new HeadsetResult.PartResult(part.Name, part.Age?.TotalSeconds, part.Reason))];

    void OnPose(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason)
    {
        if (reason != DropReason.None) return;
        var isNew = !_parents.TryGetValue(pose.Child, out var known);
        _parents[pose.Child] = (pose.Parent, isStationary, arrival);
        if (!isNew && known.Parent == pose.Parent) return;
        _isChanged = true;
        // The session limits the objects that it follows, but the sources of the others may use new names without end.
        if (isNew) ForgetSilent(arrival);
    }

    void ForgetSilent(HeadsetTime now)
    {
        foreach (var (name, (_, isStationary, last)) in _parents)
            if (!isStationary && now - last > MaxSilence && !_followed.Contains(name)) _parents.Remove(name);
    }
}
