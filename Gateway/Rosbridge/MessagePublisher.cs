using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Checks the stamps of a client's messages, converts them to C1, and publishes the messages. Not thread-safe.</summary>
sealed class MessagePublisher(HubSource source, ServedClock clock, PlantTimeOffers offers)
{
    /// <summary>The transforms or signals that were not published with the last message, because they break a limit of the cell.</summary>
    public List<LeftOut> LeftOut { get; } = [];

    /// <summary>Checks the stamps of a message.</summary>
    /// <param name="stamp">The newest stamp, on C1; zero for a message without a stamp.</param>
    /// <param name="rule">Names the frame and the rule that its stamp breaks; null if the text of the reason is sufficient.</param>
    /// <returns><see cref="DropReason.None"/> for valid stamps.</returns>
    public DropReason Judge(RosbridgeMessage message, out ControlTime stamp, out string rule)
    {
        rule = null;
        stamp = Publications.StampOf(message) ?? default;
        if (message.Transforms is { } transforms) return Judge(transforms, out stamp, out rule);
        return stamp == default ? DropReason.None : Judge(ref stamp);
    }

    /// <summary>Publishes a message.</summary>
    /// <param name="message">The message, whose stamps are valid.</param>
    /// <param name="stamp">Stamp of the message, on C1.</param>
    /// <param name="receivedAt">Time at which the last byte of the message was read, a count of <see cref="System.Diagnostics.Stopwatch"/>.</param>
    /// <returns>Null if the message was published.</returns>
    public Refusal? Publish(RosbridgeMessage message, ControlTime stamp, long receivedAt)
    {
        var robot = message.RobotTopic.Robot;
        if (message.JointState is { } state)
            return source.Publish(state.Stamp == stamp ? state : state.At(stamp), receivedAt, robot);
        if (message.JointTrajectory is { } plan)
            return source.Publish(plan.Stamp == stamp ? plan : plan.At(stamp), receivedAt, robot);
        if (message.Data != null)
            return source.Describe(message.Data, robot);
        if (message.Transforms is { } transforms)
            return source.Publish(transforms, message.Topic == RosTopics.TfStatic, LeftOut, receivedAt);
        if (message.Signals is { } signals)
        {
            signals.Stamp = stamp;
            return source.Publish(signals, LeftOut, receivedAt);
        }

        if (message.Displayed != null)
            source.PublishDisplayed(message.Displayed);
        else
            source.Publish(message.Diagnostics);
        return null;
    }

    /// <summary>Passes a stamp to the comparison of clocks, unless the joints, frames or signals of the message belong to another source.</summary>
    /// <param name="isRefused">Whether the message was refused because the stamp is in the future.</param>
    public void AddStamp(RosbridgeMessage message, ControlTime stamp, bool isRefused)
    {
        if (stamp == default || offers.StampClock != null || !IsSample(message)) return;
        // An accepted message needs no check of the owner, because the hub has already checked it.
        if (!isRefused || MayPublish(message)) clock.Stamps.Add(source, stamp, isRefused);
    }

    // Excludes /tf_static, because the stamp of a stationary frame is not the time of a sample.
    static bool IsSample(RosbridgeMessage message) => message.JointState != null || message.Signals != null || message.Topic == RosTopics.Tf;

    bool MayPublish(RosbridgeMessage message)
    {
        if (message.JointState is { } state) return source.MayPublish(message.RobotTopic.Robot, state.Names);
        return message.Signals is { } signals ? source.MayPublish(signals) : source.MayPublish(message.Transforms);
    }

    // Converts the stamp to C1 if the client stamps with another clock of the plant, and checks that it is not in the future.
    DropReason Judge(ref ControlTime stamp)
    {
        if (!clock.TryMap(offers.StampClock, stamp, out stamp))
            return DropReason.Unsynchronised;
        return StampRule.IsInFuture(stamp, clock.Now, clock.ErrorBound) ? DropReason.StampInFuture : DropReason.None;
    }

    // Does not convert a zero stamp, which only a stationary frame may have.
    DropReason Judge(TransformsMessage transforms, out ControlTime newest, out string rule)
    {
        newest = default;
        rule = null;
        for (var i = 0; i < transforms.Count; i++)
        {
            var stamp = transforms[i].Stamp;
            if (stamp == default) continue;
            var reason = Judge(ref stamp);
            if (stamp > newest) newest = stamp;
            if (reason != DropReason.None)
            {
                rule = $"frame {RequestText.Short(transforms[i].Child)}: {DropMessages.Of(reason)}";
                return reason;
            }

            transforms.SetStamp(i, stamp);
        }

        return DropReason.None;
    }
}
