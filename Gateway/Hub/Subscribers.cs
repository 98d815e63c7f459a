using System.Collections.Immutable;

namespace Nowpose.Gateway.Hub;

/// <summary>The subscribers of each topic. Thread-safe; publishing takes no lock.</summary>
sealed class Subscribers
{
    readonly Lock _lock = new();
    ImmutableDictionary<string, ImmutableArray<Action<HubMessage>>> _all = ImmutableDictionary<string, ImmutableArray<Action<HubMessage>>>.Empty;

    /// <summary>Number of topics with at least one subscriber.</summary>
    public int Topics => Volatile.Read(ref _all).Count;

    /// <summary>Gets the name that stands for one topic of all robots that have a namespace.</summary>
    /// <param name="kind">The topic without the namespace.</param>
    public static string OfAllRobots(string kind) => "/*" + kind;

    /// <returns>Ends the subscription.</returns>
    public IDisposable Add(string topic, Action<HubMessage> receive)
    {
        lock (_lock) Volatile.Write(ref _all, _all.SetItem(topic, _all.GetValueOrDefault(topic, []).Add(receive)));
        return new Subscriber(this, topic, receive);
    }

    public void Publish(HubMessage message)
    {
        var all = Volatile.Read(ref _all);
        foreach (var receive in all.GetValueOrDefault(message.Topic, [])) receive(message);
        if (message.Robot.Length == 0) return;
        foreach (var receive in all.GetValueOrDefault(OfAllRobots(message.Kind), [])) receive(message);
    }

    void Remove(string topic, Action<HubMessage> receive)
    {
        lock (_lock)
        {
            var left = _all.GetValueOrDefault(topic, []).Remove(receive);
            // Removes a topic without subscribers, because a client may subscribe to any number of topics, one after the other.
            Volatile.Write(ref _all, left.IsEmpty ? _all.Remove(topic) : _all.SetItem(topic, left));
        }
    }

    sealed class Subscriber(Subscribers owner, string topic, Action<HubMessage> receive) : IDisposable
    {
        public void Dispose() => owner.Remove(topic, receive);
    }
}
