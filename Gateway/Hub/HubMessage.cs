using System.Text;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>One message on its way to the subscribers of its topic: written once for each spelling of time, for all of them.</summary>
public sealed class HubMessage
{
    readonly Lazy<byte[]> _sec;
    readonly Lazy<byte[]> _secs;

    HubMessage(string topic, Func<RosTimeForm, string> write)
    {
        Topic = topic;
        _sec = new Lazy<byte[]>(() => Encoding.UTF8.GetBytes(write(RosTimeForm.Sec)));
        _secs = new Lazy<byte[]>(() => Encoding.UTF8.GetBytes(write(RosTimeForm.Secs)));
    }

    public string Topic { get; }

    public static HubMessage Of(JointStateMessage message) =>
        new(RosTopics.JointStates, form => RosbridgeWriter.PublishJointState(RosTopics.JointStates, message, form));

    public static HubMessage Of(JointTrajectoryMessage message) =>
        new(RosTopics.JointTrajectory, form => RosbridgeWriter.PublishJointTrajectory(RosTopics.JointTrajectory, message, form));

    public static HubMessage Of(DiagnosticsMessage message) =>
        new(RosTopics.Diagnostics, form => RosbridgeWriter.PublishDiagnostics(RosTopics.Diagnostics, message, form));

    public static HubMessage Description(string urdf) =>
        new(RosTopics.RobotDescription, _ => RosbridgeWriter.PublishString(RosTopics.RobotDescription, urdf));

    /// <summary>The message as UTF-8; the same array for all who ask.</summary>
    public ReadOnlyMemory<byte> Utf8(RosTimeForm form) => form == RosTimeForm.Secs ? _secs.Value : _sec.Value;
}
