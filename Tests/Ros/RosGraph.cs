using System.Collections.Concurrent;
using System.Text.Json.Nodes;
using Nowpose.Gateway.Clock;

namespace Nowpose.Headless.Tests.Ros;

/// <summary>Simulates the ROS graph behind a rosbridge server: topics with their types, the time, and rosbridge's log.</summary>
sealed class RosGraph(RosFlavour flavour, IControlClock clock)
{
    readonly Dictionary<string, string> _types = [];
    readonly Dictionary<string, string> _latched = [];
    readonly List<(string Topic, Action<string> Send)> _subscribers = [];
    readonly ConcurrentQueue<string> _log = [];
    readonly ConcurrentQueue<(string Topic, JsonObject Message)> _published = [];

    public RosFlavour Flavour => flavour;

    /// <summary>Whether the node rosapi also runs.</summary>
    public bool HasRosapi { get; set; } = true;

    /// <summary>Namespace of the nodes rosbridge and rosapi, such as /robot1; empty if they have none.</summary>
    public string Namespace { get; init; } = "";

    /// <summary>
    /// Errors in the log of rosbridge that requests of clients caused. Rosbridge reports an error to the client only if a service call fails.
    /// </summary>
    public IReadOnlyCollection<string> Log => _log;

    /// <summary>Messages that clients published and that match the type of their topic.</summary>
    public IReadOnlyCollection<(string Topic, JsonObject Message)> Published => _published;

    public JsonObject Time()
    {
        var nanoseconds = clock.Now.Nanoseconds;
        var (whole, rest) = (nanoseconds / 1_000_000_000, nanoseconds % 1_000_000_000);
        return flavour == RosFlavour.Ros1
            ? new JsonObject { ["secs"] = whole, ["nsecs"] = rest } : new JsonObject { ["sec"] = whole, ["nanosec"] = rest };
    }

    public void Error(string text) => _log.Enqueue(text);

    /// <summary>Publishes a message as a ROS node.</summary>
    /// <param name="text">Complete rosbridge message that clients receive.</param>
    /// <param name="isLatched">Whether the message is kept for later subscribers: latched in ROS 1, transient local in ROS 2.</param>
    public void Publish(string topic, string type, string text, bool isLatched = false)
    {
        lock (_types)
        {
            _types[topic] = type;
            if (isLatched) _latched[topic] = text;
            foreach (var subscriber in _subscribers)
                if (subscriber.Topic == topic) subscriber.Send(text);
        }
    }

    /// <summary>Registers a topic with its type. If the topic is already registered, checks that the type is the same.</summary>
    /// <exception cref="RosException">The type differs. The message is the same as in rosbridge.</exception>
    public void Establish(string topic, string type)
    {
        lock (_types)
        {
            var present = _types.GetValueOrDefault(topic);
            if (type == null && present == null) throw new RosException($"Cannot infer topic type for topic {topic} as it is not yet advertised");
            var named = type == null ? present : NameOf(type);
            if (present != null && present != named)
                throw new RosException($"Tried to register topic {topic} with type {named} but it is already established with type {present}");
            _types[topic] = named;
        }
    }

    public void Subscribe(string topic, Action<string> send)
    {
        lock (_types)
        {
            _subscribers.Add((topic, send));
            if (_latched.TryGetValue(topic, out var kept)) send(kept);
        }
    }

    public void Forget(Action<string> send)
    {
        lock (_types) _subscribers.RemoveAll(subscriber => subscriber.Send == send);
    }

    /// <summary>Receives a message that a client has published.</summary>
    /// <exception cref="RosException">The message has a field that the type lacks. In ROS 2, for example, header.seq does not exist.</exception>
    public void Receive(string topic, JsonObject message)
    {
        string type;
        lock (_types) type = _types[topic];
        if (message["header"] is JsonObject header)
            foreach (var (field, _) in header)
                if (field is not ("stamp" or "frame_id") && !(flavour == RosFlavour.Ros1 && field == "seq"))
                    throw new RosException($"Message type {type} does not have a field header.{field}");
        _published.Enqueue((topic, message));
    }

    // ROS 1 accepts only package/Name. ROS 2 also accepts a name with a middle part, and removes this part.
    string NameOf(string type)
    {
        var parts = type.Split('/', StringSplitOptions.RemoveEmptyEntries);
        if (parts.Length == 3 && flavour == RosFlavour.Ros2) return $"{parts[0]}/{parts[2]}";
        return parts.Length == 2 ? type : throw new RosException($"{type} is not a valid type string");
    }
}
