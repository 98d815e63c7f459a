namespace Nowpose.Gateway.Hub;

/// <summary>The owners of the names on the topics of robots: joints, planned joints and "the robot". Bounded; not thread-safe.</summary>
sealed class JointOwners
{
    /// <summary>
    /// Maximum number of names on a topic. Larger than the maximum of one message, because several sources may publish on a topic, each several sets of
    /// joints, and a source keeps its names until it releases the topic.
    /// </summary>
    internal const int MaxNames = 4 * ProtocolLimits.Joints;

    /// <summary>Maximum number of names of one source on a topic, so that a source with many names leaves room for the others.</summary>
    internal const int MaxNamesOfSource = MaxNames / 2;

    /// <summary>Maximum number of reported refused names of one message, so that a message with many of them does not delay the others.</summary>
    internal const int MaxReported = 16;

    // The number of topics is bounded by the maximum number of robots.
    readonly Dictionary<string, OwnerMap<string>> _topics = [];

    /// <summary>
    /// Returns the namespace of the robot of a joint in the status, by the joint's cell-wide name; null for a joint that is not in the status. The joints
    /// of a source that has failed stay in the status. Called under the hub's lock; null before there is a status.
    /// </summary>
    public Func<string, string> RobotOfListedJoint { private get; set; }

    /// <summary>Gets the refusal of names of which one belongs to another source; null if there is none.</summary>
    public Refusal? FindTaken(HubSource source, string topic, string[] names)
    {
        var owners = _topics.GetValueOrDefault(topic);
        return names.Select(name => OfAnotherSource(source, owners, name)).FirstOrDefault(taken => taken != null);
    }

    /// <summary>
    /// Makes a source the owner of names on a robot's topic: of the free names of a joint state, and of all or none of other names. A joint is free
    /// if no other source owns it, and if no joint of another robot has the same cell-wide name, as the joint a/b of the robot without a namespace and
    /// the joint b of the robot a have.
    /// </summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="use">Records that the source publishes on the topic; returns a refusal if it cannot.</param>
    /// <param name="claimed">The names that the source owns now; empty if the whole message is refused.</param>
    /// <param name="taken">The first names that are not free, at most <see cref="MaxReported"/>.</param>
    /// <returns>The first refusal of a name, or that of the whole message; null if there is none.</returns>
    public Refusal? Claim(
        HubSource source, string robot, string kind, string[] names, Func<Refusal?> use, out string[] claimed, out IReadOnlyList<Refusal> taken)
    {
        var topic = RobotTopic.NameOf(robot, kind);
        var owners = _topics.GetValueOrDefault(topic);
        var isStates = kind == RosTopics.JointStates;
        var refused = new List<Refusal>();
        var free = Array.FindAll(names, name =>
        {
            var reason = OfAnotherSource(source, owners, name) ?? (isStates ? OfAnotherRobot(robot, name) : null);
            if (reason != null && refused.Count < MaxReported) refused.Add(reason.Value);
            return reason == null;
        });
        taken = refused;
        claimed = [];
        if (refused.Count > 0 && (!isStates || free.Length == 0)) return refused[0];
        if ((FindExcess(source, topic, owners, free) ?? use()) is { } whole) return whole;
        if (owners == null) _topics[topic] = owners = new OwnerMap<string>();
        foreach (var name in free) owners.Take(source, name);
        claimed = free;
        return refused.Count == 0 ? null : refused[0];
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

    // Returns the refusal of names with which the topic or the source would have too many names; null if there is room.
    static Refusal? FindExcess(HubSource source, string topic, OwnerMap<string> owners, string[] names)
    {
        if (owners == null) return null;
        var added = names.Count(name => owners[name] == null);
        var rule = added == 0 ? null
            : owners.Count + added > MaxNames ? DropMessages.TooManyNames(MaxNames)
            : owners.CountOf(source) + added > MaxNamesOfSource ? DropMessages.TooManyNamesOfSource(MaxNamesOfSource) : null;
        return rule == null ? null : new Refusal(DropReason.TooManyJoints, topic, Rule: rule);
    }

    /// <param name="owners">Owners of the names on the topic; null if there are none.</param>
    static Refusal? OfAnotherSource(HubSource source, OwnerMap<string> owners, string name) =>
        owners?.OtherThan(source, name) is { } owner ? new Refusal(DropReason.JointTaken, name, owner) : null;

    Refusal? OfAnotherRobot(string robot, string name)
    {
        var (otherRobot, otherName) = RobotTopic.OtherOf(robot, name);
        if (otherName == null) return null;
        var topic = RobotTopic.NameOf(otherRobot, RosTopics.JointStates);
        var owner = _topics.TryGetValue(topic, out var owners) ? owners[otherName] : null;
        return owner != null || RobotOfListedJoint?.Invoke(RobotTopic.Qualified(robot, name)) == otherRobot
            ? new Refusal(DropReason.JointTaken, name, owner, DropMessages.SameCellName(topic, otherName)) : null;
    }
}
