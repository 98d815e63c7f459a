using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Checks the stamps of a client's messages, converts them to C1, and publishes the messages. Not thread-safe.</summary>
sealed class MessagePublisher(HubSource source, ServedClock clock, PlantTimeOffers offers)
{
    bool _isPublished;

    /// <summary>The transforms or signals of the present message that are not published.</summary>
    public List<LeftOut> LeftOut { get; } = [];

    /// <summary>A fault of the message that was published last, as a predicate; null if it has none.</summary>
    public string Warning { get; private set; }

    /// <summary>Checks the stamps of a message. Leaves out transforms with invalid stamps, unless all stamps of the message are invalid.</summary>
    /// <param name="stamp">The newest valid stamp, or the newest one if none is valid, on C1; zero for a message without a stamp.</param>
    /// <returns><see cref="DropReason.None"/> for valid stamps.</returns>
    public DropReason Judge(RosbridgeMessage message, out ControlTime stamp)
    {
        stamp = Publications.StampOf(message) ?? default;
        if (message.Transforms != null) return JudgeTransforms(message, out stamp);
        // An adapter stamps with the clock of its machine, as its report of each joint requires. The stamp is used only with other times of that clock.
        if (message.Diagnostics is { } diagnostics) return StatusObjects.IsAdapter(diagnostics.HardwareId) ? DropReason.None : OfFuture(diagnostics.Stamp);
        return stamp == default ? DropReason.None : Judge(ref stamp);
    }

    /// <summary>Gets the text of a reason for which <see cref="Judge(RosbridgeMessage, out ControlTime)"/> rejects a message.</summary>
    public string TextOf(DropReason reason) => reason == DropReason.Unsynchronised && offers.StampClock is { WrongRate: { } rate } wrong
        ? DropMessages.ClockRate(EventTexts.ClockAtWrongRate(wrong.Name, rate)) : DropMessages.Of(reason);

    /// <summary>Publishes a message.</summary>
    /// <param name="message">The message, whose stamps are valid.</param>
    /// <param name="stamp">Stamp of the message, on C1.</param>
    /// <param name="receivedAt">Time at which the last byte of the message was read, a timestamp of the hub's time provider.</param>
    /// <returns>Null if the message was published.</returns>
    public Refusal? Publish(RosbridgeMessage message, ControlTime stamp, long receivedAt)
    {
        _isPublished = true;
        Warning = null;
        var robot = message.RobotTopic.Robot;
        if (message.JointState is { } state)
            return source.Publish(state.Stamp == stamp ? state : state.At(stamp), receivedAt, robot);
        if (message.JointTrajectory is { } plan)
            return source.Publish(plan.Stamp == stamp ? plan : plan.At(stamp), receivedAt, robot);
        if (message.Data != null)
        {
            var refusal = source.Describe(message.Data, out var fault, robot);
            if (refusal == null && fault != null) Warning = DropMessages.InvalidDescription(fault);
            return refusal;
        }

        if (message.Transforms is { } transforms)
            _isPublished = source.Publish(transforms, message.Topic == RosTopics.TfStatic, LeftOut, receivedAt);
        else if (message.Signals is { } signals)
        {
            signals.Stamp = stamp;
            _isPublished = source.Publish(signals, LeftOut, receivedAt);
        }
        else if (message.Displayed != null)
            source.Publish(RosTopics.Displayed, message.Displayed);
        else
            source.Publish(RosTopics.Diagnostics, message.Diagnostics);
        return null;
    }

    /// <summary>Passes a stamp to the comparison of clocks, unless the joints, frames or signals of the message belong to another source.</summary>
    /// <param name="isRefused">Whether the message was refused because the stamp is in the future.</param>
    public void AddStamp(RosbridgeMessage message, ControlTime stamp, bool isRefused)
    {
        if (stamp == default || !IsSample(message)) return;
        // A published message needs no check of the owner, because the hub has already checked it.
        if (isRefused ? MayPublish(message) : _isPublished) clock.Stamps.Add(source, stamp, isRefused, OfferedBound);
    }

    TimeSpan? OfferedBound => offers.StampClock is { } offered ? clock.ErrorBoundOf(offered) : null;

    // Excludes /tf_static, because the stamp of a stationary frame is not the time of a sample.
    static bool IsSample(RosbridgeMessage message) => message.JointState != null || message.Signals != null || message.Topic == RosTopics.Tf;

    bool MayPublish(RosbridgeMessage message)
    {
        if (message.JointState is { } state) return source.MayPublish(message.RobotTopic.Robot, state.Names);
        return Publications.PartsOf(message).All(name => source.MayPublishPart(CellKinds.Of(message.Topic), name));
    }

    // Converts the stamp to C1 if the client stamps with another clock of the plant, and checks that it is not in the future.
    DropReason Judge(ref ControlTime stamp)
    {
        if (!clock.TryMap(offers.StampClock, stamp, out stamp))
            return DropReason.Unsynchronised;
        return OfFuture(stamp);
    }

    DropReason OfFuture(ControlTime stamp) =>
        StampRule.IsInFuture(stamp, clock.Now, clock.ErrorBound) ? DropReason.StampInFuture : DropReason.None;

    // Does not convert a zero stamp, which only a stationary frame may have.
    DropReason JudgeTransforms(RosbridgeMessage message, out ControlTime newest)
    {
        var transforms = message.Transforms;
        var (valid, invalid) = (default(ControlTime), default(ControlTime));
        List<LeftOut> wrong = null;
        for (var i = 0; i < transforms.Count; i++)
        {
            var stamp = transforms[i].Stamp;
            if (stamp == default) continue;
            var reason = Judge(ref stamp);
            if (reason == DropReason.None)
            {
                transforms.SetStamp(i, stamp);
                if (stamp > valid) valid = stamp;
                continue;
            }

            var child = transforms[i].Child;
            (wrong ??= []).Add(new LeftOut(reason, child, $"frame {RequestText.Short(child)}: {TextOf(reason)}"));
            if (stamp > invalid) invalid = stamp;
        }

        var isAnyValid = wrong == null || wrong.Count < transforms.Count;
        newest = isAnyValid ? valid : invalid;
        if (wrong == null) return DropReason.None;
        LeftOut.AddRange(wrong);
        if (!isAnyValid) return wrong[0].Reason;
        message.Transforms = MessageParts.Part(transforms, i => !wrong.Exists(one => one.Name == transforms[i].Child));
        return DropReason.None;
    }
}
