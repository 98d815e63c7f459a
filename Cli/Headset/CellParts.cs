using Nowpose.Protocol.Cell;
using Nowpose.Session;
using Nowpose.Session.Cell;

namespace Nowpose.Cli.Headset;

/// <summary>Follows all objects and signals that a session receives, and lists those that are not current.</summary>
sealed class CellParts
{
    readonly CompensationSession _session;
    readonly HashSet<string> _frames = new(StringComparer.Ordinal);
    readonly List<string> _added = [];

    public CellParts(CompensationSession session)
    {
        _session = session;
        session.Frames.Judged += OnPose;
        session.Signals.NeedAll();
    }

    /// <summary>Predicts the objects that have arrived for the first time. Call it after each frame, because the session calls the handler within one.</summary>
    public void Update()
    {
        foreach (var name in _added)
            if (!_session.Frames.Tree.IsLink(name)) _session.Frames.Need(name);
        _added.Clear();
    }

    /// <summary>Gets the objects and the signals that are not current, as the diagnostics list them.</summary>
    public (HeadsetResult.PartResult[] Objects, HeadsetResult.PartResult[] Signals) NotCurrent(HeadsetTime now)
    {
        var faults = _session.Cell.Faults(now);
        return (Results(faults.Objects), Results(faults.Signals));
    }

    static HeadsetResult.PartResult[] Results(IReadOnlyList<PartStatus> parts) =>
        [.. parts.Select(part => new HeadsetResult.PartResult(part.Name, part.Age?.TotalSeconds, part.Reason))];

    void OnPose(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason)
    {
        if (reason == DropReason.None && _frames.Add(pose.Child)) _added.Add(pose.Child);
    }
}
