using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Recording;
using Nowpose.Kinematics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>
/// Logs, once per joint, that a published position is beyond the joint's limits in the robot description. Thread-safe; does not block publishers.
/// </summary>
sealed class LimitAlarm : IDisposable
{
    readonly Action<string> _log;
    readonly Lock _lock = new();
    readonly IDisposable[] _subscriptions;
    DescribedRobot _described = DescribedRobot.None;
    LimitWatch _watch;
    RobotModel _robot;
    int _logged;

    public LimitAlarm(MessageHub hub, Action<string> log)
    {
        _log = log;
        _subscriptions = [hub.Subscribe(RosTopics.RobotDescription, Describe), hub.Subscribe(RosTopics.JointStates, Take)];
    }

    /// <summary>The described robot; null without a valid description, or while the description is still being parsed.</summary>
    public RobotModel Robot
    {
        get
        {
            lock (_lock) return _robot;
        }
    }

    /// <summary>Joints whose current position is beyond their limits.</summary>
    public IReadOnlyList<JointBeyondLimits> Beyond
    {
        get
        {
            lock (_lock) return _watch == null ? [] : [.. _watch.Found.Where(_watch.IsBeyond)];
        }
    }

    /// <summary>Names of the joints whose current position is beyond their limits.</summary>
    public IReadOnlyList<string> Joints => [.. Beyond.Select(found => found.Joint.Name)];

    public void Dispose()
    {
        foreach (var subscription in _subscriptions) subscription.Dispose();
    }

    void Describe(HubMessage message)
    {
        var described = new DescribedRobot((string)message.Content);
        lock (_lock)
        {
            // Ignores an equal description, which a source sends after each reconnection, so that no joint is logged twice.
            if (described.Urdf == _described.Urdf) return;
            _described = described;
        }

        _ = Task.Run(() => Follow(described));
    }

    // Parses the description, which is slow.
    void Follow(DescribedRobot described)
    {
        var robot = described.Model;
        lock (_lock)
        {
            if (described != _described) return;
            (_robot, _logged) = (robot, 0);
            _watch = robot == null ? null : new LimitWatch(robot);
        }
    }

    void Take(HubMessage message)
    {
        if (message.Content is not JointStateMessage state) return;
        List<string> words = null;
        lock (_lock)
        {
            if (_watch == null) return;
            for (var i = 0; i < state.Names.Length; i++)
            {
                var joint = _robot.IndexOfMovingJoint(state.Names[i]);
                if (joint >= 0) _watch.Add(joint, state.Positions[i]);
            }

            for (; _logged < _watch.Found.Count; _logged++) (words ??= []).Add(_watch.Found[_logged].Words);
        }

        words?.ForEach(_log);
    }
}
