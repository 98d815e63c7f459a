namespace Nowpose.Gateway.Messages;

/// <summary>Responses to requests from rosbridge clients, and log lines about them.</summary>
static class RequestMessages
{
    public static string NotAccepted(string kind, string reason) => $"websocket: a connection could not be accepted ({kind}: {reason})";
    public static string OtherType(string topic, string type, string given) => $"{topic} has the type {type}, not {given}; use {type}";

    public static string PublishedType(string type, string given) => $"has the type {type}, not {given}, and is read as such; use {type}";

    public const string NotAWebSocket = "this port serves rosbridge v2 over WebSocket; connect with a WebSocket client";

    public static string Closed(Closure why) => $"websocket: closed a connection (reason: {why})";

    public static string NoPong(string address, double kiloBytesPerSecond) =>
        FormattableString.Invariant($"websocket: {address} does not answer pings, so it receives at most {kiloBytesPerSecond:0} kB/s");

    public static string NoSlash(string topic) => $"a topic name must begin with a slash: use /{topic}";

    public static string NotPublished(string topics) =>
        $"receives no messages, because the gateway never publishes this topic. Its topics: {topics}";

    /// <param name="id">The id of the request, if the client has other subscriptions to the topic; null otherwise.</param>
    public static string NotSubscribed(string id) => id == null
        ? "has no effect, because this client has no subscription to this topic; use the topic of the subscription"
        : $"has no effect, because this client has no subscription to this topic with the id {id}; use the id of the subscription, or no id";

    /// <param name="form">The format that the subscription gets.</param>
    public static string OtherTimeForm(RosTimeForm form) =>
        $"gets times as {(form == RosTimeForm.Secs ? "secs and nsecs" : "sec and nanosec")}, like the client's first subscription to this topic; use "
            + "types of the same ROS version for all subscriptions to a topic";

    public const string NotAdvertised = "has no effect, because this client has not advertised this topic; use the topic of the advertisement";

    /// <param name="name">The name that the client used first.</param>
    public static string OneName(string name) =>
        $"cannot be used on this connection, which already has the name {name}; open another connection for another name";

    public static string UnknownOperation(string operation, string allowed) => $"Unknown operation: {operation}. Allowed operations: {allowed}";

    public static string Dropped(string source, string trouble, DropReason reason) =>
        $"the gateway drops the samples of {source}: {trouble} ({reason})";

    public static string Compression(string compression) =>
        $"compression {compression} is not supported; use none. Messages are sent as JSON text";

    public static string FragmentSize(string size) =>
        $"fragment_size {size} is not supported; remove it. The gateway splits no message into rosbridge fragments";

    public const string Qos = "qos is not supported; remove it. The gateway uses no quality of service of ROS";

    public static string QueueLength(int given, int max) =>
        $"queue_length {given} is more than the maximum of {max}; the queue holds {max} messages. Use {max} or less";

    public static string Latch(string topic) =>
        $"latch is not supported on {topic}; remove it. A new subscriber receives only messages that are published later";

    public static string Level(string level) => $"level {level} is not supported and has no effect; use info, warning, error or none";
}
