using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Recording;
using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Gateway.Status;

/// <summary>
/// Logs, once per joint, that a published position is beyond the joint's limits in the description of its robot. Thread-safe; does not block publishers.
/// </summary>
sealed class LimitAlarm
{
    readonly RobotLinks _links;
    readonly Action<string> _log;
    readonly Lock _lock = new();
    // By namespace, in the order of the namespaces.
    readonly SortedDictionary<string, WatchedRobot> _robots = new(StringComparer.Ordinal);

    public LimitAlarm(MessageHub hub, Action<string> log)
    {
        (_links, _log) = (hub.Links, log);
        hub.Subscribe(RosTopics.JointStates, Take);
        hub.SubscribeToRobots(RosTopics.JointStates, Take);
        _links.Changed += Describe;
        _links.Removed += Remove;
    }

    /// <summary>The robots with a valid description that has been parsed, and their namespaces.</summary>
    public IReadOnlyList<(string Namespace, RobotModel Model)> Robots
    {
        get
        {
            lock (_lock) return [.. _robots.Where(robot => robot.Value.Model != null).Select(robot => (robot.Key, robot.Value.Model))];
        }
    }

    /// <summary>The namespaces of the robots whose description is invalid, each with the reason.</summary>
    public IReadOnlyList<(string Namespace, string Fault)> Invalid
    {
        get
        {
            lock (_lock) return [.. _robots.Where(robot => robot.Value.Fault != null).Select(robot => (robot.Key, robot.Value.Fault))];
        }
    }

    /// <summary>Joints whose current position is beyond their limits, with their cell-wide names.</summary>
    public IReadOnlyList<(string Name, JointBeyondLimits Found)> Beyond
    {
        get
        {
            lock (_lock)
                return
                [
                    .. from robot in _robots
                       where robot.Value.Watch != null
                       from found in robot.Value.Watch.Found
                       where robot.Value.Watch.IsBeyond(found)
                       select (RobotTopic.Qualified(robot.Key, found.Joint.Name), found),
                ];
        }
    }

    /// <summary>Cell-wide names of the joints whose current position is beyond their limits.</summary>
    public IReadOnlyList<string> Joints => [.. Beyond.Select(one => one.Name)];

    void Describe(string robot, DescribedRobot described)
    {
        // Ignores a description that a newer one has replaced in the meantime, and that of a robot that the hub has removed.
        lock (_lock)
            if (_links.Described.GetValueOrDefault(robot) == described) _robots[robot] = new WatchedRobot(described);
    }

    void Remove(string robot)
    {
        lock (_lock) _robots.Remove(robot);
    }

    void Take(HubMessage message)
    {
        if (message.Content is not JointStateMessage state) return;
        List<string> words = null;
        lock (_lock)
        {
            if (!_robots.TryGetValue(message.Robot, out var robot) || robot.Watch == null) return;
            for (var i = 0; i < state.Names.Length; i++)
            {
                var joint = robot.Model.IndexOfMovingJoint(state.Names[i]);
                if (joint >= 0) robot.Watch.Add(joint, state.Positions[i]);
            }

            for (; robot.Logged < robot.Watch.Found.Count; robot.Logged++)
            {
                var found = robot.Watch.Found[robot.Logged].Words;
                (words ??= []).Add(message.Robot.Length == 0 ? found : RobotMessages.OfRobot(message.Robot, found));
            }
        }

        words?.ForEach(_log);
    }

    sealed class WatchedRobot(DescribedRobot described)
    {
        /// <summary>Null without a valid description.</summary>
        public RobotModel Model => described.Model;

        /// <summary>The reason why the description is invalid; null if it is valid.</summary>
        public string Fault => described.Fault;

        /// <summary>Null without a valid description.</summary>
        public LimitWatch Watch { get; } = described.Model == null ? null : new LimitWatch(described.Model);

        /// <summary>Number of joints that have been logged.</summary>
        public int Logged { get; set; }
    }
}
