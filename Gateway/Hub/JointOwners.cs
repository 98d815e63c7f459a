using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>The owners of the names on the topics of robots: joints, planned joints and "the robot". Bounded; not thread-safe.</summary>
sealed class JointOwners
{
    /// <summary>
    /// Maximum number of names on a topic. Larger than the maximum of one message, because several sources may publish on a topic, each several sets of
    /// joints, and a source keeps its names until it releases the topic.
    /// </summary>
    internal const int MaxNames = 4 * ProtocolLimits.Joints;

    // The number of topics is bounded by the maximum number of robots.
    readonly Dictionary<string, OwnerMap<string>> _topics = [];

    /// <summary>
    /// Returns the namespace of the robot of a joint in the status, by the joint's cell-wide name; null for a joint that is not in the status. The joints
    /// of a source that has failed stay in the status. Called under the hub's lock; null before there is a status.
    /// </summary>
    public Func<string, string> RobotOfListedJoint { private get; set; }

    /// <summary>Gets the refusal of names of which one belongs to another source; null if there is none.</summary>
    public Refusal? FindTaken(HubSource source, string topic, string[] names) =>
        _topics.TryGetValue(topic, out var owners) && Array.Find(names, name => owners.OtherThan(source, name) != null) is { } taken
            ? new Refusal(DropReason.JointTaken, taken, owners[taken]) : null;

    /// <summary>
    /// Gets the refusal of joints of which one has the cell-wide name of another robot's joint; null if there is none. The joint a/b of the robot
    /// without a namespace and the joint b of the robot a have the same one.
    /// </summary>
    public Refusal? FindOfAnotherRobot(string robot, string kind, string[] names)
    {
        if (kind != RosTopics.JointStates) return null;
        foreach (var name in names)
        {
            var (otherRobot, otherName) = RobotTopic.OtherOf(robot, name);
            if (otherName == null) continue;
            var topic = RobotTopic.NameOf(otherRobot, kind);
            var owner = _topics.TryGetValue(topic, out var owners) ? owners[otherName] : null;
            if (owner != null || RobotOfListedJoint?.Invoke(RobotTopic.Qualified(robot, name)) == otherRobot)
                return new Refusal(DropReason.JointTaken, name, owner, DropMessages.SameCellName(topic, otherName));
        }

        return null;
    }

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
        if (!_topics.TryGetValue(topic, out var owners)) _topics[topic] = owners = new OwnerMap<string>();
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
