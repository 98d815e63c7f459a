using System.Collections.Immutable;
using Nowpose.Gateway.Status;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>Distributes messages from sources to subscribers. Thread-safe; publishing never waits for a subscriber.</summary>
public sealed class MessageHub
{
    readonly Lock _lock = new();
    readonly Dictionary<(string Topic, string Name), HubSource> _owners = [];
    ImmutableDictionary<string, ImmutableArray<Action<HubMessage>>> _subscribers =
        ImmutableDictionary<string, ImmutableArray<Action<HubMessage>>>.Empty;
    readonly Dictionary<HubSource, HubMessage> _newest = [];
    HubMessage _description;

    /// <summary>Number of topics with at least one subscriber.</summary>
    internal int Topics => Volatile.Read(ref _subscribers).Count;

    /// <summary>The robot description; null until a source has published one.</summary>
    internal string Description
    {
        get
        {
            lock (_lock) return (string)_description?.Content;
        }
    }

    /// <summary>Times from the receipt of joint states until they are written to the subscribers' sockets.</summary>
    public ForwardingTimes Forwarding { get; } = new();

    /// <summary>Raised when a sample was refused: the source, the joint, and the joint's owner. Called under the hub's lock.</summary>
    internal event Action<HubSource, string, HubSource> JointRefused;

    /// <summary>
    /// Raised when a sample was dropped for its content: the source, the joints named in it, and the reason. Joints of other sources are excluded.
    /// </summary>
    internal event Action<HubSource, string[], string> SampleDropped;

    /// <summary>Raised when a client closed its connection normally, with its name.</summary>
    internal event Action<string> Left;

    /// <summary>Raised when a source ended normally: it closed its connection or unadvertised its joint states.</summary>
    internal event Action<HubSource> SourceLeft;

    /// <summary>Creates a publisher. A joint belongs to the first source that publishes it, until that source is disposed.</summary>
    public HubSource OpenSource() => new(this);

    /// <summary>Calls <paramref name="receive"/> for every message of a topic from now on, on the publisher's thread: it must not wait.</summary>
    /// <remarks>A robot description that was published before is passed immediately, and so are each source's newest set-points.</remarks>
    public IDisposable Subscribe(string topic, Action<HubMessage> receive)
    {
        lock (_lock)
        {
            var present = _subscribers.GetValueOrDefault(topic, []);
            _subscribers = _subscribers.SetItem(topic, present.Add(receive));
            if (topic == RosTopics.RobotDescription && _description != null)
                receive(_description);
            foreach (var message in _newest.Values.Where(message => message.Topic == topic))
                receive(message);
        }

        return new Subscriber(this, topic, receive);
    }

    internal void Publish(HubMessage message)
    {
        var subscribers = Volatile.Read(ref _subscribers).GetValueOrDefault(message.Topic, []);
        foreach (var receive in subscribers)
            receive(message);
    }

    internal void PublishDescription(HubMessage message)
    {
        // Under the lock, so that a new subscriber gets it exactly once, as the kept or as the new message.
        lock (_lock)
        {
            _description = message;
            Publish(message);
        }
    }

    /// <summary>Publishes a message that stays valid until its source publishes the next.</summary>
    internal void PublishNewest(HubSource source, HubMessage message)
    {
        // Under the lock, like the description.
        lock (_lock)
        {
            _newest[source] = message;
            Publish(message);
        }
    }

    /// <summary>Claims all of the names or none.</summary>
    /// <returns>The name that belongs to another source, or null if all were claimed.</returns>
    internal string Claim(HubSource source, string topic, string[] names)
    {
        lock (_lock)
        {
            if (FindTaken(source, topic, names) is { } taken)
            {
                if (topic == RosTopics.JointStates) JointRefused?.Invoke(source, taken, _owners[(topic, taken)]);
                return taken;
            }

            foreach (var name in names)
                _owners[(topic, name)] = source;
            return null;
        }
    }

    internal bool IsFree(HubSource source, string[] names)
    {
        lock (_lock) return FindTaken(source, RosTopics.JointStates, names) == null;
    }

    internal void ReportLeft(string name) => Left?.Invoke(name);

    internal void ReportLeft(HubSource source) => SourceLeft?.Invoke(source);

    internal void ReportDropped(HubSource source, string[] names, string reason)
    {
        lock (_lock)
        {
            // A valid sample would have been refused, too, so the joints of the other source are not affected.
            if (FindTaken(source, RosTopics.JointStates, names) is { } taken)
            {
                JointRefused?.Invoke(source, taken, _owners[(RosTopics.JointStates, taken)]);
                return;
            }
        }

        SampleDropped?.Invoke(source, names, reason);
    }

    internal void Release(HubSource source, string topic)
    {
        lock (_lock)
        {
            var owned = _owners.Where(entry => entry.Value == source && (topic == null || entry.Key.Topic == topic));
            foreach (var entry in owned.ToList())
                _owners.Remove(entry.Key);
            if (_newest.TryGetValue(source, out var newest) && (topic == null || newest.Topic == topic))
                _newest.Remove(source);
        }
    }

    // Gets the first name that belongs to another source; null if there is none. Called under the lock.
    string FindTaken(HubSource source, string topic, string[] names) =>
        Array.Find(names, name => _owners.TryGetValue((topic, name), out var owner) && owner != source);

    void Unsubscribe(string topic, Action<HubMessage> receive)
    {
        lock (_lock)
        {
            var left = _subscribers.GetValueOrDefault(topic, []).Remove(receive);
            // Removed when unused: a client may subscribe to any number of topics, which must not accumulate.
            _subscribers = left.IsEmpty ? _subscribers.Remove(topic) : _subscribers.SetItem(topic, left);
        }
    }

    sealed class Subscriber(MessageHub hub, string topic, Action<HubMessage> receive) : IDisposable
    {
        public void Dispose() => hub.Unsubscribe(topic, receive);
    }
}
