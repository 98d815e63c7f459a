using System.Text;

namespace Nowpose.Gateway.Hub;

/// <summary>One message for the subscribers of its topic. It is serialised once per time format, and all subscribers share the result.</summary>
public sealed class HubMessage
{
    readonly Lazy<byte[]> _sec;
    readonly Lazy<byte[]> _secs;

    /// <summary>Creates a message on a topic of the cell.</summary>
    /// <param name="source">See <see cref="Source"/>.</param>
    /// <param name="receivedAt">See <see cref="ReceivedAt"/>.</param>
    internal HubMessage(string topic, IRosMessage content, HubSource source, long receivedAt)
    {
        Topic = topic;
        Source = source;
        Content = content;
        ReceivedAt = receivedAt;
        _sec = new Lazy<byte[]>(() => Write(RosTimeForm.Sec));
        _secs = new Lazy<byte[]>(() => Write(RosTimeForm.Secs));
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

    /// <summary>The deserialised message: an object of the topic's type.</summary>
    internal IRosMessage Content { get; }

    /// <summary>
    /// Time at which the last byte of the message was read, or at which this process created it: a timestamp of the hub's time provider.
    /// </summary>
    public long ReceivedAt { get; }

    /// <summary>Creates a message on a topic of a robot.</summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="kind">The topic without the namespace.</param>
    /// <param name="joints">See <see cref="Joints"/>.</param>
    internal static HubMessage OfRobot(
        string robot, string kind, IRosMessage content, HubSource source, long receivedAt, string[] joints = null) =>
        new(RobotTopic.NameOf(robot, kind), content, source, receivedAt) { Kind = kind, Robot = robot, Joints = joints };

    /// <summary>Creates a message with a robot description.</summary>
    /// <inheritdoc cref="OfRobot" path="/param[@name='robot']"/>
    internal static HubMessage Description(string urdf, string robot, HubSource source, long receivedAt) =>
        OfRobot(robot, RosTopics.RobotDescription, new StringMessage(urdf), source, receivedAt);

    /// <summary>Sets the <see cref="Sequence"/> and returns this message.</summary>
    internal HubMessage With(long sequence)
    {
        Sequence = sequence;
        return this;
    }

    /// <summary>Creates a message with a part of the joints, transforms or signals of this one.</summary>
    /// <param name="joints">See <see cref="Joints"/>.</param>
    internal HubMessage With(IRosMessage part, string[] joints = null) =>
        new HubMessage(Topic, part, Source, ReceivedAt) { Kind = Kind, Robot = Robot, Joints = joints }.With(Sequence);

    /// <summary>Whether the message is longer in one of the time formats than clients accept.</summary>
    internal bool IsTooLong => Kind == RosTopics.RobotDescription
        ? _sec.Value.Length > ProtocolLimits.DescriptionBytes
        : Math.Max(_sec.Value.Length, _secs.Value.Length) > ProtocolLimits.MessageBytes;

    /// <summary>Gets the message as UTF-8. All callers receive the same array and must not change it.</summary>
    internal ReadOnlyMemory<byte> Utf8(RosTimeForm form) => form == RosTimeForm.Secs ? _secs.Value : _sec.Value;

    byte[] Write(RosTimeForm form) => Encoding.UTF8.GetBytes(RosbridgeWriter.Publish(Topic, Content, form));
}
