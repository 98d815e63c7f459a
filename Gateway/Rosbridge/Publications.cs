using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>The topics of the gateway. Topics of a robot exist in every namespace.</summary>
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
        [RosTopics.SignalStatus] = RosTopics.DiagnosticsType,
        [RosTopics.Version] = RosTopics.StringType,
        [RosTopics.Tf] = RosTopics.TransformsType,
        [RosTopics.TfStatic] = RosTopics.TransformsType,
        [RosTopics.Signals] = RosTopics.SignalsType,
    };

    /// <summary>All topics without a namespace, with their types.</summary>
    public static IReadOnlyCollection<KeyValuePair<string, string>> All => Types;

    /// <summary>All topics without a namespace, and those of the given robots, with their types.</summary>
    /// <param name="robots">Namespaces.</param>
    public static IEnumerable<KeyValuePair<string, string>> With(IEnumerable<string> robots) => Types.Concat(robots.SelectMany(robot =>
        RobotTopic.OfRobots.Select(kind => KeyValuePair.Create(RobotTopic.NameOf(robot, kind), Types[kind]))));

    /// <summary>Gets the type of a known topic, with its ROS 1 name.</summary>
    public static string TypeOf(RobotTopic topic) => Types[topic.Kind];

    public static bool IsKnown(RobotTopic topic) => Types.ContainsKey(topic.Kind);

    /// <summary>Whether clients can publish on the topic. Only the gateway publishes its version and the state of joints and signals.</summary>
    public static bool IsOpen(RobotTopic topic) => IsKnown(topic) && topic.Kind is not (RosTopics.JointStatus or RosTopics.SignalStatus or RosTopics.Version);

    /// <summary>Whether a type matches that of a known topic, with its ROS 1 or ROS 2 name. A missing type matches, too.</summary>
    public static bool HasType(RobotTopic topic, string type) =>
        string.IsNullOrEmpty(type) || type.Replace("/msg/", "/", StringComparison.Ordinal) == TypeOf(topic);

    /// <summary>Whether the topic describes only its sender, so that every client may publish it.</summary>
    public static bool IsOfItself(RobotTopic topic) => topic.Kind is RosTopics.Diagnostics or RosTopics.Displayed;

    /// <summary>Gets the client's own name in a message; null for kinds of messages without one.</summary>
    public static string NameIn(RosbridgeMessage message) => message.Diagnostics?.HardwareId ?? message.Displayed?.FrameId;

    /// <summary>Gets the stamp that must not be in the future; null if there is none. Each transform has its own stamp.</summary>
    public static ControlTime? StampOf(RosbridgeMessage message) =>
        (message.JointState ?? message.Displayed)?.Stamp ?? message.JointTrajectory?.Stamp ?? message.Signals?.Stamp;
}
