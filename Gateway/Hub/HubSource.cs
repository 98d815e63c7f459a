using System.Diagnostics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Hub;

/// <summary>One publisher on the hub: a plant in this process, or a client. Disposing it releases its joints.</summary>
public sealed class HubSource : IDisposable
{
    static readonly string[] TheRobot = ["the robot"];

    /// <summary>Name of a source of this process.</summary>
    internal const string Own = "gateway";

    /// <summary>Name of a client that has not named itself.</summary>
    internal const string Unnamed = "rosbridge";

    readonly MessageHub _hub;
    // The names of the last claim: a source sends the same ones repeatedly.
    string[] _claimed = [];

    internal HubSource(MessageHub hub) => _hub = hub;

    /// <summary>Name for users; for an adapter, the adapter's name.</summary>
    internal string Name { get; set; } = Own;

    /// <summary>Remote address of a client, without the port; null for a source of this process.</summary>
    internal string Address { get; set; }

    /// <summary>Name for messages, with the address if the client has not named itself.</summary>
    internal string Title => Name == Unnamed && Address != null ? $"{Name} {Address}" : Name;

    /// <summary>Publishes to all subscribers, unless a joint of the message belongs to another source.</summary>
    /// <param name="receivedAt">Time at which its last byte was read, a count of <see cref="Stopwatch"/>; null for now.</param>
    /// <returns>The name of that joint, or null if the message was published.</returns>
    public string TryPublish(JointStateMessage message, long? receivedAt = null)
    {
        var taken = message.Names.AsSpan().SequenceEqual(_claimed) ? null : _hub.Claim(this, RosTopics.JointStates, message.Names);
        if (taken != null)
            return taken;
        _claimed = message.Names;
        _hub.Publish(HubMessage.Of(message, receivedAt ?? Stopwatch.GetTimestamp(), this));
        return null;
    }

    /// <summary>Publishes set-points. The newest of each source are kept for later subscribers, because they stay valid and are sent once.</summary>
    /// <inheritdoc cref="TryPublish(JointStateMessage, long?)"/>
    internal string TryPublish(JointTrajectoryMessage message, long? receivedAt = null)
    {
        var taken = _hub.Claim(this, RosTopics.JointTrajectory, message.Names);
        if (taken == null)
            _hub.PublishNewest(this, HubMessage.Of(message, receivedAt ?? Stopwatch.GetTimestamp()));
        return taken;
    }

    /// <summary>Publishes the robot description and keeps it for later subscribers, unless another source has published one.</summary>
    /// <returns>The reason for the refusal, or null if it was published.</returns>
    public string TryDescribe(string urdf)
    {
        var taken = _hub.Claim(this, RosTopics.RobotDescription, TheRobot);
        if (taken == null)
            _hub.PublishDescription(HubMessage.Description(urdf));
        return taken;
    }

    /// <summary>Publishes the pose that a headset displays. It is forwarded without owning the joints.</summary>
    public void PublishDisplayed(JointStateMessage message) => _hub.Publish(HubMessage.Displayed(message));

    internal void Publish(DiagnosticsMessage message) => _hub.Publish(HubMessage.Of(message, this));

    /// <summary>Publishes the joints that are not live; the newest message is kept for later subscribers.</summary>
    internal void PublishJointStatus(DiagnosticsMessage message) => _hub.PublishNewest(this, HubMessage.JointStatus(message));

    /// <summary>Whether none of the joints belongs to another source.</summary>
    internal bool MayPublish(string[] names) => _hub.IsFree(this, names);

    /// <summary>Reports a sample that was dropped for its content.</summary>
    /// <param name="names">The joints that it names, as far as they can be read.</param>
    internal void ReportDropped(string[] names, string reason) => _hub.ReportDropped(this, names, reason);

    /// <summary>Reports that the source ends normally, so that its missing joints are not reported for longer than usual.</summary>
    internal void Leave() => _hub.ReportLeft(this);

    /// <summary>Releases the joints claimed on one topic.</summary>
    public void Release(string topic)
    {
        _claimed = [];
        _hub.Release(this, topic);
    }

    public void Dispose() => Release(null);
}
