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

    /// <summary>All topics with their types.</summary>
    public static IReadOnlyCollection<KeyValuePair<string, string>> All => Types;

    /// <summary>Gets the type of a known topic, with its ROS 1 name.</summary>
    public static string TypeOf(string topic) => Types[topic];

    public static bool IsKnown(string topic) => Types.ContainsKey(topic);

    /// <summary>Whether clients can publish on the topic. Only the gateway publishes the state of joints.</summary>
    public static bool IsOpen(string topic) => IsKnown(topic) && topic != RosTopics.JointStatus;

    /// <summary>Whether a type matches that of a known topic, with its ROS 1 or ROS 2 name. No type matches, too.</summary>
    public static bool HasType(string topic, string type) =>
        string.IsNullOrEmpty(type) || type.Replace("/msg/", "/", StringComparison.Ordinal) == Types[topic];

    /// <summary>Whether the topic describes only its sender, so that every client may publish it.</summary>
    public static bool IsOfItself(string topic) => topic is RosTopics.Diagnostics or RosTopics.Displayed;

    /// <summary>Gets the client's own name in a message; null for kinds of messages without one.</summary>
    public static string NameIn(RosbridgeMessage message) => message.Diagnostics?.HardwareId ?? message.Displayed?.FrameId;

    /// <summary>Gets the stamp that must not be in the future; null if there is none.</summary>
    public static ControlTime? StampOf(RosbridgeMessage message) =>
        (message.JointState ?? message.Displayed)?.Stamp ?? message.JointTrajectory?.Stamp;
}
