namespace Nowpose.Gateway.Rosbridge;

/// <summary>Describes a client's request in replies.</summary>
static class RequestText
{
    public const string KnownOperations = "subscribe, unsubscribe, advertise, unadvertise, publish, call_service, advertise_service, unadvertise_service, "
        + "service_response, status, set_level";

    public static readonly string Topics =
        string.Join(", ", Publications.All.Select(topic => topic.Key).Concat(RobotTopic.OfRobots.Select(kind => RobotTopic.NameOf("ROBOT", kind))));

    /// <summary>Gets the operation and the topic or service of a request, each followed by a space; empty for an unreadable message.</summary>
    public static string Subject(RosbridgeMessage message) =>
        string.Concat(new[] { message?.OpName, message?.Topic ?? message?.Service }.Where(part => !string.IsNullOrEmpty(part)).Select(part => $"{Short(part)} "));

    public static string TypeRule(RosbridgeMessage message) =>
        RequestMessages.OtherType(message.Topic, Publications.TypeOf(message.RobotTopic), Short(message.Type));

    /// <summary>Shortens an id from a client, for replies.</summary>
    public static RequestId Short(RequestId id) => id.Text == null ? id : Short(id.Text);

    /// <summary>Shortens a string from a client to the maximum length of a name, for replies.</summary>
    public static string Short(string text) =>
        text?.Length > ProtocolLimits.NameLength ? string.Concat(text.AsSpan(0, ProtocolLimits.NameLength - 1), "…") : text;
}
