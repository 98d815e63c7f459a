using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using static Nowpose.Gateway.Rosbridge.RequestText;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Counts what a client sends in vain, reports it to the hub, and sends the client a status message. Not thread-safe.</summary>
/// <param name="source">The client as a source of the hub.</param>
/// <param name="rights">What the client may publish.</param>
/// <param name="reply">Sends a message to the client.</param>
sealed class StatusReplies(HubSource source, DropCounters drops, PublishRights rights, Action<string> reply)
{
    internal const string JointsLeftOut = "joints left out";
    internal const string MessageDropped = "dropped";

    /// <summary>Level from which the client wants to receive status messages: warning, error or none; null for all.</summary>
    public string Level { get; set; }

    /// <summary>The complete message that is being handled.</summary>
    public ReadOnlyMemory<byte> Received { get; set; }

    /// <summary>Warns of a request that is served only in part or has no effect.</summary>
    public void Warn(RosbridgeMessage message, string text)
    {
        if (Level is not ("none" or "error")) reply(RosbridgeWriter.Status("warning", Subject(message) + text, Short(message.Id)));
    }

    /// <summary>Reports a message that the hub refused, or joints that it left out of a message.</summary>
    public void Drop(RosbridgeMessage message, Refusal refusal)
    {
        var owner = refusal.Owner == null ? "" : $", {Short(refusal.Owner.Title)}";
        var rule = $"{Short(refusal.What)} {refusal.Rule ?? DropMessages.Of(refusal.Reason)}{owner}{Others(refusal.LeftOut)}";
        Drop(message, refusal.Reason, rule, refusal.IsPartial ? JointsLeftOut : MessageDropped);
    }

    /// <summary>Reports transforms or signals that were left out of a message, and clears the list. Each is counted; the client receives one status message per reason and owner.</summary>
    public void DropParts(RosbridgeMessage message, List<LeftOut> parts)
    {
        foreach (var part in parts) source.ReportDropped(message.Topic, part);
        foreach (var same in parts.GroupBy(one => (one.Reason, one.Owner)))
        {
            var count = same.Count();
            drops.Count(same.Key.Reason, count - 1);
            var owner = same.Key.Owner == null ? "" : $", {Short(same.Key.Owner.Title)}";
            Drop(message, same.Key.Reason, rule: $"{same.First().Fault}{owner}{Others(count)}");
        }

        parts.Clear();
    }

    /// <summary>Reports a dropped message.</summary>
    /// <param name="message">The readable part of the message; null if nothing can be read.</param>
    /// <param name="rule">The fault as one clause; null for the text of the reason.</param>
    /// <param name="effect">What was dropped.</param>
    public void Drop(RosbridgeMessage message, DropReason reason, string rule = null, string effect = MessageDropped)
    {
        var topic = message is { Op: RosbridgeOp.Publish, RobotTopic: { IsValid: true } published } ? published : null;
        // The content is read before the role of the client is checked, but a correct message of this client would be refused too. A name without its slash
        // does not select the topic.
        if (topic != null && message.Topic.StartsWith('/') && rights.On(topic) == DropReason.NotAllowed)
            (reason, rule) = (DropReason.NotAllowed, null);
        drops.Count(reason);
        rule ??= topic?.Kind == RosTopics.Diagnostics && reason == DropReason.LengthMismatch ? DropMessages.NotOneStatus : DropMessages.Of(reason);
        var text = reason == DropReason.UnknownOp
            ? RequestMessages.UnknownOperation(Short(message.OpName), KnownOperations)
            : $"{Subject(message)}{effect}: {rule} ({reason})";
        if (reason == DropReason.TooManyMessages) source.ReportBrokenRule(EventTexts.ExceedsRate, rule);
        // Excludes joints of other sources, which the hub reports itself.
        if (topic != null && reason != DropReason.JointTaken)
        {
            if (topic.Kind == RosTopics.JointStates) ReportDropped(topic.Robot, message.JointState, rule, reason);
            else if (topic.Kind == RosTopics.JointTrajectory) ReportRefused(topic, message.JointTrajectory, rule, reason);
        }

        // Replies last, so that a client that has received the reply finds the drop in the gateway's status.
        if (Level != "none")
            reply(RosbridgeWriter.Status("error", text, message == null ? default : Short(message.Id)));
    }

    static string Others(int count) => count > 1 ? $" ({count - 1} more)" : "";

    void ReportDropped(string robot, JointStateMessage valid, string rule, DropReason reason)
    {
        // The joints of a client that may not publish any are not joints of the plant.
        if (reason == DropReason.NotAllowed)
        {
            source.ReportBrokenRule(EventTexts.IsRefused, RequestMessages.Dropped(source.Title, rule, reason));
            return;
        }

        var (names, trouble) = valid == null ? InvalidJointState.Read(Received.Span) : (valid.Names, null);
        source.ReportDropped(robot, names, RequestMessages.Dropped(source.Title, trouble ?? rule, reason), reason);
    }

    void ReportRefused(RobotTopic topic, JointTrajectoryMessage valid, string rule, DropReason reason)
    {
        var names = valid?.Names ?? InvalidJointState.ReadPlannedNames(Received.Span);
        source.ReportRefused(topic.Robot, names.FirstOrDefault() ?? "", new Refusal(reason, topic.Robot, Rule: rule));
    }
}
