using System.Diagnostics;
using System.Text;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>One message for the subscribers of its topic. It is serialised once per time format, and all subscribers share the result.</summary>
public sealed class HubMessage
{
    readonly Lazy<byte[]> _sec;
    readonly Lazy<byte[]> _secs;

    HubMessage(string topic, object content, long receivedAt, Func<RosTimeForm, string> write, HubSource source = null)
    {
        Topic = topic;
        Source = source;
        Content = content;
        ReceivedAt = receivedAt;
        _sec = new Lazy<byte[]>(() => Encoding.UTF8.GetBytes(write(RosTimeForm.Sec)));
        _secs = new Lazy<byte[]>(() => Encoding.UTF8.GetBytes(write(RosTimeForm.Secs)));
    }

    public string Topic { get; }

    /// <summary>The topic without the robot's namespace; null for topics of the cell.</summary>
    internal string Kind { get; private init; }

    /// <summary>Namespace of the robot; empty if it has none.</summary>
    internal string Robot { get; private init; } = "";

    /// <summary>The cell-wide names of the joints in a joint state: <c>arm1/a</c> for the joint a of the robot arm1.</summary>
    internal string[] Joints { get; private init; }

    /// <summary>Sequence number of the message on the topics /tf, /tf_static and /signals; 0 on other topics.</summary>
    internal long Sequence { get; private set; }

    /// <summary>The source, or null if unknown.</summary>
    internal HubSource Source { get; }

    /// <summary>The deserialised message: an object of the topic's type, or a string for the robot description.</summary>
    public object Content { get; }

    /// <summary>
    /// Time at which the last byte of the message was read, or at which this process created it, as a <see cref="Stopwatch"/> timestamp.
    /// </summary>
    public long ReceivedAt { get; }

    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="joints">See <see cref="Joints"/>.</param>
    internal static HubMessage Of(string robot, JointStateMessage message, string[] joints, long receivedAt, HubSource source)
    {
        var topic = RobotTopic.NameOf(robot, RosTopics.JointStates);
        return new HubMessage(topic, message, receivedAt, form => RosbridgeWriter.PublishJointState(topic, message, form), source)
        {
            Kind = RosTopics.JointStates, Robot = robot, Joints = joints,
        };
    }

    internal static HubMessage Of(JointTrajectoryMessage message, long receivedAt, string robot = "", HubSource source = null)
    {
        var topic = RobotTopic.NameOf(robot, RosTopics.JointTrajectory);
        return new HubMessage(topic, message, receivedAt, form => RosbridgeWriter.PublishJointTrajectory(topic, message, form), source)
        {
            Kind = RosTopics.JointTrajectory, Robot = robot,
        };
    }

    internal static HubMessage Of(DiagnosticsMessage message, HubSource source = null) => new(
        RosTopics.Diagnostics, message, Stopwatch.GetTimestamp(), form => RosbridgeWriter.PublishDiagnostics(RosTopics.Diagnostics, message, form),
        source);

    /// <param name="topic">/tf or /tf_static.</param>
    internal static HubMessage Of(string topic, TransformsMessage message, long receivedAt, HubSource source) => new(
        topic, message, receivedAt, form => RosbridgeWriter.PublishTransforms(topic, message, form), source);

    internal static HubMessage Of(SignalsMessage message, long receivedAt, HubSource source) => new(
        RosTopics.Signals, message, receivedAt, form => RosbridgeWriter.PublishSignals(RosTopics.Signals, message, form), source);

    /// <summary>Creates the message with the list of joints that are not live, for headsets.</summary>
    internal static HubMessage JointStatus(DiagnosticsMessage message) => new(
        RosTopics.JointStatus, message, Stopwatch.GetTimestamp(),
        form => RosbridgeWriter.PublishDiagnostics(RosTopics.JointStatus, message, form));

    /// <summary>Creates the message with the list of signals without current values, for headsets.</summary>
    internal static HubMessage SignalStatus(DiagnosticsMessage message) => new(
        RosTopics.SignalStatus, message, Stopwatch.GetTimestamp(),
        form => RosbridgeWriter.PublishDiagnostics(RosTopics.SignalStatus, message, form));

    /// <summary>Creates a message with the version of the gateway.</summary>
    internal static HubMessage Version(string version) => new(
        RosTopics.Version, version, Stopwatch.GetTimestamp(), _ => RosbridgeWriter.PublishString(RosTopics.Version, version));

    /// <summary>Creates a message with the pose that a headset displays. It is not a sample of the robot.</summary>
    public static HubMessage Displayed(JointStateMessage message) => new(
        RosTopics.Displayed, message, Stopwatch.GetTimestamp(), form => RosbridgeWriter.PublishJointState(RosTopics.Displayed, message, form));

    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    internal static HubMessage Description(string urdf, string robot = "")
    {
        var topic = RobotTopic.NameOf(robot, RosTopics.RobotDescription);
        return new HubMessage(topic, urdf, Stopwatch.GetTimestamp(), _ => RosbridgeWriter.PublishString(topic, urdf))
        {
            Kind = RosTopics.RobotDescription, Robot = robot,
        };
    }

    /// <summary>Sets the <see cref="Sequence"/> and returns this message.</summary>
    internal HubMessage With(long sequence)
    {
        Sequence = sequence;
        return this;
    }

    /// <summary>Creates a message with a part of the transforms of this one.</summary>
    internal HubMessage With(TransformsMessage part) => Of(Topic, part, ReceivedAt, Source).With(Sequence);

    /// <summary>Creates a message with a part of the joints of this one.</summary>
    /// <param name="joints">See <see cref="Joints"/>.</param>
    internal HubMessage With(JointStateMessage part, string[] joints) => Of(Robot, part, joints, ReceivedAt, Source);

    /// <summary>Whether the message is longer in one of the time formats than clients accept.</summary>
    internal bool IsTooLong => Math.Max(_sec.Value.Length, _secs.Value.Length) > ProtocolLimits.MessageBytes;

    /// <summary>Gets the message as UTF-8. All callers receive the same array and must not change it.</summary>
    internal ReadOnlyMemory<byte> Utf8(RosTimeForm form) => form == RosTimeForm.Secs ? _secs.Value : _sec.Value;
}
