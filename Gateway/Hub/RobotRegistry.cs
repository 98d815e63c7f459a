namespace Nowpose.Gateway.Hub;

/// <summary>
/// The descriptions of all robots, and the robots that have a namespace and either a source or a description. Bounded; not thread-safe.
/// </summary>
sealed class RobotRegistry
{
    // Keyed by topic, including the robot's namespace.
    readonly Dictionary<string, HubMessage> _descriptions = [];

    // In the order in which the robots were first used.
    readonly List<(string Robot, HashSet<(HubSource Source, string Topic)> Users)> _robots = [];

    /// <summary>Namespaces of the robots that have one.</summary>
    public IEnumerable<string> Names => _robots.Select(one => one.Robot);

    /// <summary>Gets the newest message on a topic of descriptions; null if there is none.</summary>
    public HubMessage DescriptionOn(string topic) => _descriptions.GetValueOrDefault(topic);

    /// <summary>Keeps the description of a robot.</summary>
    public void Describe(HubMessage message) => _descriptions[message.Topic] = message;

    /// <summary>Records that a source publishes on a topic of a robot.</summary>
    /// <param name="removed">A robot without a source that was removed to make room for the new robot; null if none was removed.</param>
    /// <returns>False if the maximum number of robots is reached.</returns>
    public bool TryUse(string robot, HubSource source, string topic, out string removed)
    {
        removed = null;
        if (robot.Length == 0) return true;
        var present = _robots.FindIndex(one => one.Robot == robot);
        if (present < 0 && _robots.Count >= ProtocolLimits.Robots)
        {
            var unused = _robots.FindIndex(one => one.Users.Count == 0);
            if (unused < 0) return false;
            removed = _robots[unused].Robot;
            _robots.RemoveAt(unused);
            _descriptions.Remove(TopicOf(removed));
        }

        if (present < 0)
        {
            present = _robots.Count;
            _robots.Add((robot, []));
        }

        _robots[present].Users.Add((source, topic));
        return true;
    }

    /// <summary>Records that a source ends. A robot that is described stays in the registry without a source.</summary>
    /// <param name="topic">The topic on which the source ends; null for all topics.</param>
    public void Release(HubSource source, string topic)
    {
        foreach (var (_, users) in _robots) users.RemoveWhere(user => user.Source == source && (topic == null || user.Topic == topic));
        _robots.RemoveAll(one => one.Users.Count == 0 && !_descriptions.ContainsKey(TopicOf(one.Robot)));
    }

    static string TopicOf(string robot) => RobotTopic.NameOf(robot, RosTopics.RobotDescription);
}
