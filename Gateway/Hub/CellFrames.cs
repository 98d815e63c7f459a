using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>The frames of the cell: their sources, the tree over all sources, and the newest poses of stationary frames. Not thread-safe.</summary>
/// <remarks>
/// A tracked frame is removed when its source ends. A stationary frame stays, because it does not move. Without a source, it may be taken
/// over by another source, and it is removed when the cell is full and a new frame appears.
/// </remarks>
sealed class CellFrames(RobotLinks links)
{
    readonly Dictionary<string, Frame> _frames = [];
    readonly FrameParents _parents = new(links.RootOf);

    public LatchedMessages Stationary { get; } = new(Only);

    /// <summary>Returns the source that owns a frame, if it is another one; null otherwise.</summary>
    public HubSource OtherOwner(HubSource source, string child) =>
        _frames.TryGetValue(child, out var frame) && frame.Owner != source ? frame.Owner : null;

    /// <summary>
    /// Adds or updates the frames of a message. Leaves out frames of other sources, and transforms that would break a limit of the cell.
    /// </summary>
    /// <returns>The message itself if all its transforms were accepted; otherwise a message with the accepted ones, which may be empty.</returns>
    public TransformsMessage Accept(HubSource source, TransformsMessage message, bool isStationary, List<LeftOut> leftOut)
    {
        TransformsMessage accepted = null;
        for (var i = 0; i < message.Count; i++)
        {
            var child = message[i].Child;
            var owner = OtherOwner(source, child);
            var reason = owner == null ? Accept(source, message[i], isStationary) : DropReason.FrameTaken;
            if (reason == DropReason.None)
            {
                accepted?.Add(message[i]);
                continue;
            }

            leftOut.Add(owner == null ? LimitBroken(reason, child, message[i].Parent)
                : new LeftOut(reason, child, CellMessageFaults.Of(CellMessageFaults.Named(CellKinds.Frame, child), reason), owner));
            accepted ??= MessageParts.Part(message, index => index < i);
        }

        return accepted ?? message;
    }

    /// <summary>Releases the frames of a source that ends.</summary>
    /// <param name="topic">The topic on which the source ends; null for all topics.</param>
    public void Release(HubSource source, string topic)
    {
        foreach (var (child, frame) in _frames.Where(one => one.Value.Owner == source).ToArray())
        {
            if (topic != null && topic != (frame.IsStationary ? RosTopics.TfStatic : RosTopics.Tf)) continue;
            frame.Owner = null;
            if (!frame.IsStationary) Remove(child);
        }
    }

    /// <summary>Removes the frames that form a cycle through a robot, because the robot was described after them.</summary>
    /// <returns>The sources of the removed frames, which may have ended, and the faults.</returns>
    public IReadOnlyList<(HubSource Source, LeftOut Frame)> RemoveCycles()
    {
        var inCycle = _frames.Where(one => _parents.IsInCycle(one.Key))
            .Select(one => (one.Value.Source, LimitBroken(DropReason.FrameCycle, one.Key, _parents[one.Key]))).ToArray();
        foreach (var (_, frame) in inCycle) Remove(frame.Name);
        return inCycle;
    }

    static LeftOut LimitBroken(DropReason reason, string child, string parent) =>
        new(reason, child, CellMessageFaults.Of(CellMessageFaults.Frame(child, parent), reason));

    DropReason Accept(HubSource source, in FrameTransform transform, bool isStationary)
    {
        var reason = _parents.TrySet(transform.Child, transform.Parent);
        if (reason == DropReason.TooManyFrames && _frames.FirstOrDefault(one => one.Value.Owner == null).Key is { } abandoned)
        {
            Remove(abandoned);
            reason = _parents.TrySet(transform.Child, transform.Parent);
        }

        if (reason != DropReason.None) return reason;
        if (!_frames.TryGetValue(transform.Child, out var frame)) _frames[transform.Child] = frame = new Frame();
        if (!isStationary && frame.IsStationary) Stationary.Remove(transform.Child);
        (frame.Owner, frame.Source, frame.IsStationary) = (source, source, isStationary);
        return DropReason.None;
    }

    void Remove(string child)
    {
        _frames.Remove(child);
        _parents.Remove(child);
        Stationary.Remove(child);
    }

    static HubMessage Only(HubMessage message, Predicate<string> isCurrent)
    {
        var whole = (TransformsMessage)message.Content;
        var part = MessageParts.Part(whole, index => isCurrent(whole[index].Child));
        return part.Count == whole.Count ? message : HubMessage.Of(message.Topic, part, message.ReceivedAt, message.Source).With(message.Sequence);
    }

    sealed class Frame
    {
        /// <summary>Source that publishes the frame; null for a stationary frame whose source has ended.</summary>
        public HubSource Owner { get; set; }

        /// <summary>Source of the newest pose.</summary>
        public HubSource Source { get; set; }

        public bool IsStationary { get; set; }
    }
}
