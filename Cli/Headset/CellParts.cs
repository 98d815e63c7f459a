using Nowpose.Frames;
using Nowpose.Messages;
using Nowpose.Protocol.Cell;
using Nowpose.Session;

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
        session.Signals.Need();
    }

    /// <summary>Predicts the objects that have arrived for the first time. Call it after each frame, because the session calls the handler within one.</summary>
    public void Update()
    {
        foreach (var name in _added) _session.Frames.Need(name);
        _added.Clear();
    }

    /// <summary>Gets the objects that have a reason of their own for not being current, sorted by name.</summary>
    public IReadOnlyList<HeadsetResult.PartResult> Objects(HeadsetTime now) =>
    [
        .. from name in _frames.Order(StringComparer.Ordinal)
           where !_session.Frames.Tree.IsLink(name)
           let frame = _session.Frames.Find(name)
           where _session.Frames.StateOf(frame) is PoseState.Held or PoseState.Incomplete
           select new HeadsetResult.PartResult(name, AgeOf(_session.Frames.HeldSince(frame), now), new FrameFault().Of(frame, _session.Frames.Tree)),
    ];

    /// <summary>Gets the same for the signals.</summary>
    public IReadOnlyList<HeadsetResult.PartResult> Signals(HeadsetTime now) =>
    [
        .. from index in Enumerable.Range(0, _session.Signals.Table.Count)
           let name = _session.Signals.Table[index].Name
           let fault = _session.Signals.FaultOf(name, _session.CanReceiveSignals)
           where fault.Reason is not null and not SignalMessages.ClockUnsynchronised
           orderby name
           select new HeadsetResult.PartResult(name, AgeOf(fault.Since, now), fault.Reason),
    ];

    void OnPose(in FrameTransform pose, bool isStationary, HeadsetTime arrival, DropReason reason)
    {
        if (reason == DropReason.None && _frames.Add(pose.Child)) _added.Add(pose.Child);
    }

    double? AgeOf(ControlTime? since, HeadsetTime now) =>
        _session.Clock.ModelAt(now) is { IsKnown: true } clock ? (clock.ToControl(now) - since)?.TotalSeconds : null;
}
