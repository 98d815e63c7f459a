using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>The robots that have a namespace and either a source or a kept description. Bounded; not thread-safe.</summary>
sealed class RobotRegistry
{
    // In the order in which the robots were first used.
    readonly List<(string Robot, HashSet<(HubSource Source, string Topic)> Users)> _robots = [];

    /// <summary>Namespaces of the robots.</summary>
    public IEnumerable<string> Names => _robots.Select(one => one.Robot);

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
        }

        if (present < 0)
        {
            present = _robots.Count;
            _robots.Add((robot, []));
        }

        _robots[present].Users.Add((source, topic));
        return true;
    }

    /// <summary>Records that a source ends.</summary>
    /// <param name="topic">The topic on which the source ends; null for all topics.</param>
    /// <param name="isKept">Returns whether a robot stays in the registry without a source.</param>
    public void Release(HubSource source, string topic, Predicate<string> isKept)
    {
        foreach (var (_, users) in _robots) users.RemoveWhere(user => user.Source == source && (topic == null || user.Topic == topic));
        _robots.RemoveAll(one => one.Users.Count == 0 && !isKept(one.Robot));
    }
}
