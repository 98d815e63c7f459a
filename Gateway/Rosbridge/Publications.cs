namespace Nowpose.Gateway.Rosbridge;

/// <summary>The topics of the gateway and their types. Each topic of a robot exists in every namespace.</summary>
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

    /// <summary>Gets all topics without a namespace and the topics of the given robots, with their types.</summary>
    /// <param name="robots">Namespaces of the robots.</param>
    public static IEnumerable<KeyValuePair<string, string>> With(IEnumerable<string> robots) => Types.Concat(robots.SelectMany(robot =>
        RobotTopic.OfRobots.Select(kind => KeyValuePair.Create(RobotTopic.NameOf(robot, kind), Types[kind]))));

    /// <summary>Gets the ROS 1 name of a known topic's type.</summary>
    public static string TypeOf(RobotTopic topic) => Types[topic.Kind];

    public static bool IsKnown(RobotTopic topic) => Types.ContainsKey(topic.Kind);

    /// <summary>Whether a type name of ROS 1 or ROS 2 is the type of a known topic. Also true for a missing name.</summary>
    public static bool HasType(RobotTopic topic, string type) =>
        string.IsNullOrEmpty(type) || type.Replace("/msg/", "/", StringComparison.Ordinal) == TypeOf(topic);

    /// <summary>Whether a subscriber to a known topic receives messages that were published before.</summary>
    public static bool IsKept(RobotTopic topic) =>
        topic.Kind is not (RosTopics.JointStates or RosTopics.Tf or RosTopics.Diagnostics or RosTopics.Displayed);

    /// <summary>Gets the sender's name in a message; null for messages without a sender's name.</summary>
    public static string NameIn(RosbridgeMessage message) => message.Diagnostics?.HardwareId ?? message.Displayed?.FrameId;

    /// <summary>Whether a topic contains frames or signals, which may have different sources.</summary>
    public static bool HasParts(string topic) => topic is RosTopics.Tf or RosTopics.TfStatic or RosTopics.Signals;

    /// <summary>Gets the names of the frames or signals in a message.</summary>
    public static IEnumerable<string> PartsOf(RosbridgeMessage message)
    {
        for (var i = 0; i < message.Transforms?.Count; i++) yield return message.Transforms[i].Child;
        for (var i = 0; i < message.Signals?.Count; i++) yield return message.Signals[i].Name;
    }

    /// <summary>Gets the stamp of a message; null for a message without a stamp, and for transforms, which have a stamp each.</summary>
    public static ControlTime? StampOf(RosbridgeMessage message) =>
        (message.JointState ?? message.Displayed)?.Stamp ?? message.JointTrajectory?.Stamp ?? message.Signals?.Stamp;
}
