using System.Diagnostics;
using System.Text;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>One message for the subscribers of its topic. It is serialised once per time format, for all of them.</summary>
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

    /// <summary>The source, or null if unknown.</summary>
    internal HubSource Source { get; }

    /// <summary>The deserialised message: an object of the topic's type, or a text for the robot description.</summary>
    public object Content { get; }

    /// <summary>Time at which its last byte was read, or at which it was created in this process; a count of <see cref="Stopwatch"/>.</summary>
    public long ReceivedAt { get; }

    public static HubMessage Of(JointStateMessage message, long receivedAt, HubSource source = null) => new(
        RosTopics.JointStates, message, receivedAt, form => RosbridgeWriter.PublishJointState(RosTopics.JointStates, message, form), source);

    internal static HubMessage Of(JointTrajectoryMessage message, long receivedAt) =>
        new(RosTopics.JointTrajectory, message, receivedAt, form => RosbridgeWriter.PublishJointTrajectory(RosTopics.JointTrajectory, message, form));

    internal static HubMessage Of(DiagnosticsMessage message, HubSource source = null) => new(
        RosTopics.Diagnostics, message, Stopwatch.GetTimestamp(), form => RosbridgeWriter.PublishDiagnostics(RosTopics.Diagnostics, message, form),
        source);

    /// <summary>Creates a message with the joints that are not live, for headsets.</summary>
    internal static HubMessage JointStatus(DiagnosticsMessage message) => new(
        RosTopics.JointStatus, message, Stopwatch.GetTimestamp(),
        form => RosbridgeWriter.PublishDiagnostics(RosTopics.JointStatus, message, form));

    /// <summary>Creates a message with the pose that a headset displays. It is not a sample of the robot.</summary>
    public static HubMessage Displayed(JointStateMessage message) => new(
        RosTopics.Displayed, message, Stopwatch.GetTimestamp(), form => RosbridgeWriter.PublishJointState(RosTopics.Displayed, message, form));

    public static HubMessage Description(string urdf) => new(
        RosTopics.RobotDescription, urdf, Stopwatch.GetTimestamp(), _ => RosbridgeWriter.PublishString(RosTopics.RobotDescription, urdf));

    /// <summary>Gets the message as UTF-8; the same array for all callers.</summary>
    internal ReadOnlyMemory<byte> Utf8(RosTimeForm form) => form == RosTimeForm.Secs ? _secs.Value : _sec.Value;
}
