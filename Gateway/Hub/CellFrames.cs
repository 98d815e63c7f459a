using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>The frames of the cell: their sources, the tree over all sources, and the newest poses of stationary frames. Not thread-safe.</summary>
/// <remarks>
/// A tracked frame is removed when its source ends. A stationary frame stays, because it does not move. Without a source, it may be taken
/// over by another source. In a full cell, a new frame replaces a tracked frame that is silent, because a source may give each workpiece a new name, and
/// otherwise a stationary frame without a source.
/// </remarks>
/// <param name="samples">Receives the moving poses.</param>
/// <param name="publish">Gives a message its sequence number and publishes it.</param>
/// <param name="drop">Reports a transform that is dropped after its message was accepted, with its source and topic.</param>
sealed class CellFrames(
    RobotLinks links, NewestSamples samples, TimeProvider time, Action<HubMessage> publish, Action<HubSource, string, LeftOut> drop)
{
    /// <summary>Time without poses after which a new frame may replace a tracked frame.</summary>
    static readonly TimeSpan MaxSilence = TimeSpan.FromSeconds(10);

    // With the source of the newest pose, which may have ended, and the time of its arrival.
    readonly Dictionary<string, (HubSource Source, bool IsStationary, long ReceivedAt)> _frames = [];
    readonly FrameParents _parents = new(links.RootOf);
    // The newest poses of stationary frames that were refused because the frame belongs to another source, or because they are invalid.
    readonly RefusedValues<RefusedPose> _refused = new(pose => pose.Stamp);
    // Whether a new frame has replaced one, for which a refused pose may wait.
    bool _hasReplaced;

    /// <summary>Raised with a frame that is removed because its source has ended, or because it is in a cycle. Called under the hub's lock.</summary>
    public event Action<string> Ended;

    /// <summary>
    /// Raised with a silent frame or a stationary frame without a source that is removed to make room for a new frame. Called under the hub's lock.
    /// </summary>
    public event Action<string> Replaced;

    /// <summary>The sources that publish the frames. A stationary frame whose source has ended has none.</summary>
    public OwnerMap<string> Owners { get; } = new();

    public LatchedMessages Stationary { get; } = new(MessageParts.Only);

    /// <summary>Publishes the poses of a message. Leaves out frames of other sources, and transforms that would break a limit of the cell.</summary>
    /// <param name="receivedAt">Arrival of the message, a timestamp of the time provider.</param>
    /// <returns>Whether at least one pose was published.</returns>
    public bool Publish(HubSource source, TransformsMessage message, bool isStationary, List<LeftOut> leftOut, long receivedAt)
    {
        var isAny = PublishAccepted(source, message, isStationary, leftOut, receivedAt);
        // Otherwise no frame has lost its source. The search for refused poses would take time under the hub's lock for each message.
        if (_hasReplaced) PublishRefused();
        return isAny;
    }

    /// <summary>Keeps an invalid pose of a stationary frame that belongs to another source. It is reported as dropped when the other source ends.</summary>
    public void KeepInvalid(HubSource source, LeftOut pose) => _refused[source, pose.Name] = _refused[source, pose.Name] with { Invalid = pose };

    bool PublishAccepted(HubSource source, TransformsMessage message, bool isStationary, List<LeftOut> leftOut, long receivedAt)
    {
        var accepted = Accept(source, message, isStationary, leftOut, receivedAt);
        foreach (var part in MessageParts.Of(accepted))
        {
            var published = new HubMessage(isStationary ? RosTopics.TfStatic : RosTopics.Tf, part, source, receivedAt);
            for (var i = 0; isStationary && i < part.Count; i++) Stationary.Set(part[i].Child, published);
            if (!isStationary) samples.Set(published);
            publish(published);
        }

        return accepted.Count > 0;
    }

    // The poses of a source form one message, because they may exchange the places of frames in the tree.
    void PublishRefused()
    {
        _refused.PublishFree(Owners, (source, poses) =>
        {
            var leftOut = new List<LeftOut>();
            var message = new TransformsMessage([.. poses.Where(pose => pose.Valid != null).Select(pose => pose.Valid[0])]);
            PublishAccepted(source, message, isStationary: true, leftOut, time.GetTimestamp());
            foreach (var part in leftOut.Concat(poses.Select(pose => pose.Invalid).OfType<LeftOut>())) drop(source, RosTopics.TfStatic, part);
        });
        _hasReplaced = false;
    }

    // Adds or updates the frames of a message. Returns the message itself if all its transforms were accepted in their order; otherwise a message with the
    // accepted ones in the order in which they were accepted, which may be empty.
    TransformsMessage Accept(HubSource source, TransformsMessage message, bool isStationary, List<LeftOut> leftOut, long receivedAt)
    {
        Dictionary<int, DropReason> refused = null;
        var accepted = MessageParts.Accepted(message, message.Count, IsAccepted, MessageParts.Part);
        return refused == null ? accepted : Retried();

        bool IsAccepted(int index)
        {
            var child = message[index].Child;
            var owner = Owners.OtherThan(source, child);
            if (owner == null)
            {
                var reason = Accept(source, message[index], isStationary, receivedAt);
                if (reason is DropReason.FrameCycle or DropReason.FrameTooDeep) (refused ??= []).Add(index, reason);
                else if (reason != DropReason.None) leftOut.Add(LimitBroken(reason, child, message[index].Parent));
                return reason == DropReason.None;
            }

            if (isStationary) _refused.Keep(source, child, new RefusedPose(new TransformsMessage(message[index]), null));
            else _refused.Remove(source, child);
            leftOut.Add(new LeftOut(
                DropReason.FrameTaken, child, CellMessageFaults.Of(CellMessageFaults.Named(CellKinds.Frame, child), DropReason.FrameTaken), owner));
            return false;
        }

        // A message may exchange the places of frames in the tree. A transform is then possible only after another one of the same message. The number
        // of passes is limited, because each one takes time under the hub's lock.
        TransformsMessage Retried()
        {
            List<FrameTransform> all = [.. Enumerable.Range(0, accepted.Count).Select(index => accepted[index])];
            var before = 0;
            for (var passes = 0; passes < ProtocolLimits.FrameDepth && refused.Count != before; passes++)
            {
                before = refused.Count;
                foreach (var index in refused.Keys.Order().ToArray())
                {
                    refused[index] = Accept(source, message[index], isStationary, receivedAt);
                    if (refused[index] != DropReason.None) continue;
                    refused.Remove(index);
                    all.Add(message[index]);
                }
            }

            foreach (var (index, reason) in refused) leftOut.Add(LimitBroken(reason, message[index].Child, message[index].Parent));
            return new TransformsMessage([.. all]);
        }
    }

    /// <summary>Releases the frames of a source that ends, and publishes the refused poses of other sources for these frames.</summary>
    /// <param name="topic">The topic on which the source ends; null for all topics.</param>
    public void Release(HubSource source, string topic)
    {
        if (topic is null or RosTopics.TfStatic) _refused.Remove(source);
        foreach (var child in Owners.Release(source, child => topic == null || topic == (IsStationary(child) ? RosTopics.TfStatic : RosTopics.Tf)))
            if (!IsStationary(child)) Remove(child, Ended);
        PublishRefused();
    }

    /// <summary>Removes the frames that form a cycle through a robot, because the robot was described after them.</summary>
    public void RemoveCycles()
    {
        var inCycle = _frames.Where(one => _parents.IsInCycle(one.Key))
            .Select(one => (one.Value.Source, LimitBroken(DropReason.FrameCycle, one.Key, _parents[one.Key]))).ToArray();
        foreach (var (_, frame) in inCycle) Remove(frame.Name, Ended);
        foreach (var (source, frame) in inCycle) drop(source, RosTopics.Tf, frame);
        PublishRefused();
    }

    /// <summary>
    /// Leaves out the poses that no longer apply: those of moving frames that have become stationary since, and those of frames that are no longer
    /// stationary.
    /// </summary>
    /// <param name="message">A message on /tf or /tf_static that has waited in a queue.</param>
    /// <returns>The message itself if all its poses apply; null if none does.</returns>
    public HubMessage Applicable(HubMessage message)
    {
        var isStationary = message.Topic == RosTopics.TfStatic;
        var whole = (TransformsMessage)message.Content;
        var part = MessageParts.Accepted(whole, whole.Count, Applies, MessageParts.Part);
        return part.Count == 0 ? null : part == whole ? message : message.With(part);

        bool Applies(int index)
        {
            var stationary = Stationary.Of(whole[index].Child);
            return isStationary ? stationary != null : stationary == null || stationary.Sequence < message.Sequence;
        }
    }

    static LeftOut LimitBroken(DropReason reason, string child, string parent) =>
        new(reason, child, CellMessageFaults.Of(CellMessageFaults.Frame(child, parent), reason));

    DropReason Accept(HubSource source, in FrameTransform transform, bool isStationary, long receivedAt)
    {
        var reason = _parents.TrySet(transform.Child, transform.Parent);
        if (reason == DropReason.TooManyFrames && (SilentAt(receivedAt, transform.Parent) ?? WithoutSource(transform.Parent)) is { } unused)
        {
            Remove(unused, Replaced);
            _hasReplaced = true;
            reason = _parents.TrySet(transform.Child, transform.Parent);
        }

        if (reason != DropReason.None) return reason;
        if (!isStationary && IsStationary(transform.Child)) Stationary.Remove(transform.Child);
        Owners.Take(source, transform.Child);
        _frames[transform.Child] = (source, isStationary, receivedAt);
        // A pose of this source may have been refused before the frame was replaced by another one of the same message.
        _refused.Remove(source, transform.Child);
        return DropReason.None;
    }

    // Returns the tracked frame without children that has been silent for the longest time; null if none has been silent for long.
    string SilentAt(long now, string parent) => _frames
        .Where(one => !one.Value.IsStationary && time.GetElapsedTime(one.Value.ReceivedAt, now) > MaxSilence && IsLeaf(one.Key, parent))
        .OrderBy(one => one.Value.ReceivedAt).FirstOrDefault().Key;

    // Returns a frame without a source and without children; null if there is none.
    string WithoutSource(string parent) => _frames.Keys.FirstOrDefault(frame => Owners[frame] == null && IsLeaf(frame, parent));

    // Whether a frame has no children, with a new frame included. The links of a robot depend on its base.
    bool IsLeaf(string frame, string parentOfNew) => frame != parentOfNew && !_parents.HasChildren(frame) && links.RootOf(frame) != frame;

    bool IsStationary(string child) => _frames.GetValueOrDefault(child).IsStationary;

    void Remove(string child, Action<string> removed)
    {
        removed?.Invoke(child);
        _frames.Remove(child);
        Owners.Release(child);
        _parents.Remove(child);
        Stationary.Remove(child);
        samples.Remove(RosTopics.Tf, child);
    }

    // The newest valid pose of a source, null if there is none, and a later invalid pose.
    readonly record struct RefusedPose(TransformsMessage Valid, LeftOut? Invalid)
    {
        // A source with a valid pose precedes those that have only an invalid one.
        public ControlTime Stamp => Valid?[0].Stamp ?? new ControlTime(TimeSpan.MinValue);
    }
}
