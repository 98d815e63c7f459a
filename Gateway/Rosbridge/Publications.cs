using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The topics a client can publish on.</summary>
static class Publications
{
    static readonly Dictionary<string, string> Types = new()
    {
        [RosTopics.JointStates] = RosTopics.JointStateType,
        [RosTopics.JointTrajectory] = RosTopics.JointTrajectoryType,
        [RosTopics.RobotDescription] = RosTopics.StringType,
        [RosTopics.Diagnostics] = RosTopics.DiagnosticsType,
    };

    public static bool IsKnown(string topic) => Types.ContainsKey(topic);

    /// <summary>Whether a type named for a known topic is the topic's, in either ROS's spelling; none named is.</summary>
    public static bool HasType(string topic, string type) =>
        string.IsNullOrEmpty(type) || type == Types[topic] || type == Types[topic].Replace("/msg/", "/", StringComparison.Ordinal);

    /// <summary>The stamp that must not lie in the future; null where there is none.</summary>
    public static ControlTime? StampOf(RosbridgeMessage message) => message.JointState?.Stamp ?? message.JointTrajectory?.Stamp;
}
