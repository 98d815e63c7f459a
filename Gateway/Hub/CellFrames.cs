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

    /// <summary>Returns a refusal if the message contains a frame of another source; null otherwise.</summary>
    public Refusal? FindTaken(HubSource source, TransformsMessage message)
    {
        for (var i = 0; i < message.Count; i++)
        {
            var child = message[i].Child;
            if (_frames.TryGetValue(child, out var frame) && frame.Owner != null && frame.Owner != source)
                return new Refusal(DropReason.FrameTaken, $"frame {child}", frame.Owner);
        }

        return null;
    }

    /// <summary>Adds or updates the frames of a message. Leaves out transforms that would break a limit of the cell.</summary>
    /// <returns>The message itself if all its transforms were accepted; otherwise a message with the accepted ones, which may be empty.</returns>
    public TransformsMessage Accept(HubSource source, TransformsMessage message, bool isStationary, List<LeftOut> leftOut)
    {
        TransformsMessage accepted = null;
        for (var i = 0; i < message.Count; i++)
        {
            var reason = Accept(source, message[i], isStationary);
            if (reason == DropReason.None)
            {
                accepted?.Add(message[i]);
                continue;
            }

            leftOut.Add(new LeftOut(reason, CellMessageFaults.Frame(message[i].Child, message[i].Parent)));
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
        (frame.Owner, frame.IsStationary) = (source, isStationary);
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

        public bool IsStationary { get; set; }
    }
}
