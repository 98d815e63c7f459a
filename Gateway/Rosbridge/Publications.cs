using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The topics of the gateway.</summary>
static class Publications
{
    static readonly Dictionary<string, string> Types = new()
    {
        [RosTopics.JointStates] = RosTopics.JointStateType,
        [RosTopics.JointTrajectory] = RosTopics.JointTrajectoryType,
        [RosTopics.RobotDescription] = RosTopics.StringType,
        [RosTopics.Diagnostics] = RosTopics.DiagnosticsType,
        [RosTopics.Displayed] = RosTopics.JointStateType,
        [RosTopics.JointStatus] = RosTopics.DiagnosticsType,
    };

    /// <summary>Every topic with its type.</summary>
    public static IReadOnlyCollection<KeyValuePair<string, string>> All => Types;

    /// <summary>The type of a known topic, in ROS 1's spelling.</summary>
    public static string TypeOf(string topic) => Types[topic];

    public static bool IsKnown(string topic) => Types.ContainsKey(topic);

    /// <summary>Whether clients can publish on the topic. The gateway alone publishes the state of joints.</summary>
    public static bool IsOpen(string topic) => IsKnown(topic) && topic != RosTopics.JointStatus;

    /// <summary>Whether a type named for a known topic is the topic's, in either ROS's spelling; none named is.</summary>
    public static bool HasType(string topic, string type) =>
        string.IsNullOrEmpty(type) || type.Replace("/msg/", "/", StringComparison.Ordinal) == Types[topic];

    /// <summary>Whether it tells of its sender alone, as every client may.</summary>
    public static bool IsOfItself(string topic) => topic is RosTopics.Diagnostics or RosTopics.Displayed;

    /// <summary>What a client calls itself in a message of that kind; null in others.</summary>
    public static string NameIn(RosbridgeMessage message) => message.Diagnostics?.HardwareId ?? message.Displayed?.FrameId;

    /// <summary>The stamp that must not lie in the future; null where there is none.</summary>
    public static ControlTime? StampOf(RosbridgeMessage message) =>
        (message.JointState ?? message.Displayed)?.Stamp ?? message.JointTrajectory?.Stamp;
}
