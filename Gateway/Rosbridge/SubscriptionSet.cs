using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The subscriptions of one client, by topic and by the id that the client chose. Not thread-safe.</summary>
sealed class SubscriptionSet(MessageHub hub, int queueLength, DropCounters drops, Action<Subscription> start) : IDisposable
{
    readonly Dictionary<string, (List<(RequestId Id, SubscriptionTerms Terms)> Wishes, Subscription Live)> _topics = [];

    public IEnumerable<string> Topics => _topics.Keys;

    /// <summary>Whether a subscription can be added, or replaces one with the same id.</summary>
    public bool HasRoomFor(string topic, RequestId id) => !_topics.TryGetValue(topic, out var present)
        || present.Wishes.Count < ProtocolLimits.SubscriptionsPerTopic || present.Wishes.Exists(wish => wish.Id == id);

    /// <summary>Adds a subscription, or replaces the one with the same id.</summary>
    /// <returns>Format of times of all subscriptions to the topic, which is that of the first.</returns>
    public RosTimeForm Add(string topic, RequestId id, SubscriptionTerms terms)
    {
        var wishes = _topics.TryGetValue(topic, out var present) ? present.Wishes : [];
        wishes.RemoveAll(wish => wish.Id == id);
        wishes.Add((id, terms));
        Renew(topic, wishes, present.Live);
        return wishes[0].Terms.Form;
    }

    /// <summary>Removes one or all subscriptions to a topic.</summary>
    /// <param name="topic">Name of the topic.</param>
    /// <param name="id">Id of the subscription; no id removes all subscriptions to the topic.</param>
    /// <returns>False if there is no such subscription.</returns>
    public bool Remove(string topic, RequestId id)
    {
        if (!_topics.TryGetValue(topic, out var present) || present.Wishes.RemoveAll(wish => id.IsNone || wish.Id == id) == 0)
            return false;
        Renew(topic, present.Wishes, present.Live);
        return true;
    }

    public void Dispose()
    {
        foreach (var topic in _topics.Values)
            topic.Live.Dispose();
    }

    void Renew(string topic, List<(RequestId Id, SubscriptionTerms Terms)> wishes, Subscription before)
    {
        before?.Dispose();
        _topics.Remove(topic);
        if (wishes.Count == 0)
            return;
        var terms = wishes.Select(wish => wish.Terms).Aggregate((all, next) => all.With(next));
        var live = new Subscription(hub, topic, terms, queueLength, drops);
        _topics[topic] = (wishes, live);
        start(live);
    }
}
