using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>The owners of the names on the topics of robots: joints, planned joints and "the robot". Bounded; not thread-safe.</summary>
sealed class TopicOwners
{
    /// <summary>
    /// Maximum number of names on a topic. Larger than the maximum of one message, because several sources may publish on a topic, each several sets of
    /// joints, and a source keeps its names until it releases the topic.
    /// </summary>
    internal const int MaxNames = 4 * ProtocolLimits.Joints;

    // The number of topics is bounded by the maximum number of robots.
    readonly Dictionary<string, NameOwners<string>> _topics = [];

    /// <summary>Gets the refusal of names of which one belongs to another source; null if there is none.</summary>
    public Refusal? FindTaken(HubSource source, string topic, string[] names) =>
        _topics.TryGetValue(topic, out var owners) && Array.Find(names, name => owners.OtherThan(source, name) != null) is { } taken
            ? new Refusal(DropReason.JointTaken, taken, owners[taken]) : null;

    /// <summary>Gets the refusal of names with which the topic would have too many names; null if there is room.</summary>
    public Refusal? FindExcess(string topic, string[] names)
    {
        if (!_topics.TryGetValue(topic, out var owners)) return null;
        var isOver = owners.Count + names.Count(name => owners[name] == null) > MaxNames;
        return isOver ? new Refusal(DropReason.TooManyJoints, topic, Rule: DropMessages.TooManyNames(MaxNames)) : null;
    }

    /// <summary>Makes a source the owner of names.</summary>
    public void Take(HubSource source, string topic, string[] names)
    {
        if (!_topics.TryGetValue(topic, out var owners)) _topics[topic] = owners = new NameOwners<string>();
        foreach (var name in names) owners.Take(source, name);
    }

    /// <summary>Releases the names of a source.</summary>
    /// <param name="topic">The topic of the names; null for all topics.</param>
    public void Release(HubSource source, string topic)
    {
        foreach (var (name, owners) in _topics)
        {
            if (topic != null && name != topic) continue;
            owners.Release(source, _ => true);
            if (owners.Count == 0) _topics.Remove(name);
        }
    }
}
