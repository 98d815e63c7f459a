namespace Nowpose.Gateway.Hub;

/// <summary>
/// The newest joint state of each joint and the newest moving pose of each frame, as long as the joint or frame has a source. Thread-safe.
/// </summary>
sealed class NewestSamples
{
    readonly Lock _lock = new();

    // By topic and by the cell-wide name of the joint or the name of the frame.
    readonly Dictionary<string, Dictionary<string, HubMessage>> _topics = [];

    /// <summary>Stores a message. Call this method before its publication, so that a subscriber that then reads the newest messages misses none.</summary>
    public void Set(HubMessage message)
    {
        lock (_lock)
        {
            if (!_topics.TryGetValue(message.Topic, out var newest)) _topics[message.Topic] = newest = [];
            foreach (var name in MessageParts.NamesIn(message)) newest[name] = message;
        }
    }

    /// <summary>Whether a message is the newest one of a joint or frame.</summary>
    public bool IsNewest(HubMessage message, string name)
    {
        lock (_lock) return _topics.TryGetValue(message.Topic, out var newest) && newest.GetValueOrDefault(name) == message;
    }

    /// <summary>Gets the newest messages on a topic. A message of several joints is returned once.</summary>
    public IReadOnlyList<HubMessage> On(string topic)
    {
        lock (_lock) return _topics.TryGetValue(topic, out var newest) ? [.. newest.Values.Distinct()] : [];
    }

    /// <summary>Removes the message of a joint or frame.</summary>
    public void Remove(string topic, string name)
    {
        lock (_lock) _topics.GetValueOrDefault(topic)?.Remove(name);
    }

    /// <summary>Removes the messages of a source.</summary>
    /// <param name="topic">The topic that the source releases; null for all topics.</param>
    public void Release(HubSource source, string topic)
    {
        lock (_lock)
            foreach (var (name, newest) in _topics)
            {
                if (topic != null && name != topic) continue;
                foreach (var (joint, message) in newest)
                    if (message.Source == source) newest.Remove(joint);
                if (newest.Count == 0) _topics.Remove(name);
            }
    }
}
