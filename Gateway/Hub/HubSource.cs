using Nowpose.Gateway.Recording;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>One publisher on the hub: a plant in this process or a client. <see cref="Dispose"/> releases its joints, frames and signals.</summary>
public sealed class HubSource : IDisposable
{
    /// <summary>Name of a source in this process.</summary>
    internal const string Own = "gateway";

    /// <summary>Name of a client that has not named itself.</summary>
    internal const string Unnamed = "rosbridge";

    readonly MessageHub _hub;
    // Joint names of the last claim, by robot: caches the claim, because a source sends the same names in each message.
    readonly Dictionary<string, (string[] Names, string[] InCell, bool AreLong)> _claimed = [];

    // Descriptions of robots that were refused because another source has published one, by robot.
    readonly Dictionary<string, (HubMessage Message, DescribedRobot Described)> _refused = [];

    internal HubSource(MessageHub hub) => _hub = hub;

    /// <summary>Name shown to users; for an adapter, the adapter's name.</summary>
    internal string Name { get; set; } = Own;

    /// <summary>Remote address of a client, without the port; null for a source in this process.</summary>
    internal string Address { get; set; }

    /// <summary>Name used in messages, with the address if the client has not named itself.</summary>
    internal string Title => Name == Unnamed && Address != null ? $"{Name} {Address}" : Name;

    /// <summary>Whether the source has ended.</summary>
    internal bool IsEnded { get; private set; }

    /// <summary>Publishes to all subscribers, without the joints that belong to another source.</summary>
    /// <param name="receivedAt">
    /// Time at which the last byte of the message was read, a timestamp of the hub's time provider; null for the current time.
    /// </param>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <returns>
    /// A refusal with the name of the first joint that belongs to another source, or the refusal of the whole message; null if all joints were
    /// published.
    /// </returns>
    internal Refusal? Publish(JointStateMessage message, long? receivedAt = null, string robot = "")
    {
        Refusal? refusal = null;
        var leftOut = 0;
        if (!_claimed.TryGetValue(robot, out var claimed) || !message.Names.AsSpan().SequenceEqual(claimed.Names))
        {
            refusal = _hub.Claim(this, robot, RosTopics.JointStates, message.Names, out var free);
            if (free.Length == 0) return refusal;
            leftOut = message.Names.Length - free.Length;
            message = MessageParts.Part(message, free);
            claimed = (message.Names, InCell(robot, message.Names), AreLong(message.Names));
            // With a refused joint, the next message is claimed again, because the joint may then be free.
            if (refusal == null) _claimed[robot] = claimed;
            // A description is sent once. When this source takes over the joints of another source, it also takes over the description.
            if (_refused.TryGetValue(robot, out var refused)) Describe(refused.Message, refused.Described);
        }

        var published = HubMessage.OfRobot(robot, RosTopics.JointStates, message, this, receivedAt ?? Now, claimed.InCell);
        if (claimed.AreLong && published.IsTooLong) return new Refusal(DropReason.TooLarge, DropMessages.AsWritten);
        _hub.Samples.Set(published);
        _hub.Publish(published);
        return refusal == null ? null : refusal.Value with { LeftOut = leftOut };
    }

    /// <summary>
    /// Publishes set-points. The newest set-points of each source are kept for later subscribers, because they are sent once and stay valid.
    /// </summary>
    /// <inheritdoc cref="Publish(JointStateMessage, long?, string)"/>
    internal Refusal? Publish(JointTrajectoryMessage message, long? receivedAt = null, string robot = "")
    {
        var published = HubMessage.OfRobot(robot, RosTopics.JointTrajectory, message, this, receivedAt ?? Now);
        // The message may be longer than the received one, because numbers get more digits.
        if (published.IsTooLong) return new Refusal(DropReason.TooLarge, DropMessages.AsWritten);
        var refusal = _hub.Claim(this, robot, RosTopics.JointTrajectory, message.Names, out _);
        if (refusal == null) _hub.PublishNewest(this, published);
        return refusal;
    }

    /// <inheritdoc cref="Describe(string, out string, string)"/>
    internal Refusal? Describe(string urdf, string robot = "") => Describe(urdf, out _, robot);

    /// <summary>
    /// Publishes the robot description and keeps it for later subscribers, unless another source has published one. In that case, the description is
    /// published when this source takes over joints of the robot from the other source.
    /// </summary>
    /// <param name="fault">
    /// The reason why the description is invalid; null for a valid one. An invalid description is published if the robot has no valid one, because
    /// headsets name its fault.
    /// </param>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <returns>
    /// A refusal if another source has published a description, if this one is too long for a message, or if it is invalid and the robot has a
    /// valid one; otherwise null.
    /// </returns>
    internal Refusal? Describe(string urdf, out string fault, string robot = "")
    {
        fault = null;
        var published = HubMessage.Description(urdf, robot, this, Now);
        if (published.IsTooLong) return new Refusal(DropReason.TooLarge, DropMessages.AsWritten);
        var described = _hub.Links.Described.GetValueOrDefault(robot) is { } known && known.Urdf == urdf ? known : new(urdf, published.Topic);
        fault = described.Fault;
        return Describe(published, described);
    }

    Refusal? Describe(HubMessage message, DescribedRobot described)
    {
        var refusal = _hub.Describe(this, message, described);
        if (refusal is { Reason: DropReason.NotUrdf } invalid) _hub.ReportRefused(this, message.Topic, "", invalid);
        if (refusal?.Reason == DropReason.JointTaken) _refused[message.Robot] = (message, described);
        else _refused.Remove(message.Robot);
        return refusal;
    }

    /// <summary>
    /// Publishes poses of frames. Poses of stationary frames are kept for later subscribers.
    /// </summary>
    /// <param name="message">The message, which must not change afterwards.</param>
    /// <param name="leftOut">
    /// Receives the transforms that were not published, because the frame belongs to another source or the transform breaks a limit of the cell.
    /// </param>
    /// <returns>Whether at least one transform was published.</returns>
    /// <inheritdoc cref="Publish(JointStateMessage, long?, string)" path="/param[@name='receivedAt']"/>
    internal bool Publish(TransformsMessage message, bool isStationary, List<LeftOut> leftOut, long? receivedAt = null) =>
        _hub.Publish(this, message, isStationary, leftOut, receivedAt ?? Now);

    /// <summary>Publishes signals and keeps them for later subscribers.</summary>
    /// <param name="message">The message, which must not change afterwards.</param>
    /// <param name="leftOut">Receives the signals that were not published, because they belong to another source or the cell has too many.</param>
    /// <returns>Whether at least one signal was published.</returns>
    /// <inheritdoc cref="Publish(JointStateMessage, long?, string)" path="/param[@name='receivedAt']"/>
    internal bool Publish(SignalsMessage message, List<LeftOut> leftOut, long? receivedAt = null) =>
        _hub.Publish(this, message, leftOut, receivedAt ?? Now);

    /// <summary>Marks a robot's topic as used by this source. The namespace counts as used until the topic is released.</summary>
    /// <returns>A refusal if there are too many robots; otherwise null.</returns>
    internal Refusal? Use(RobotTopic topic) => _hub.Use(this, topic.Robot, topic.Kind);

    /// <summary>Publishes a message whose parts belong to no source, such as diagnostics or the pose that a headset displays.</summary>
    internal void Publish(string topic, IRosMessage message) => _hub.Publish(new HubMessage(topic, message, this, Now));

    /// <summary>Publishes a message whose parts belong to no source. The newest message on the topic is kept for later subscribers.</summary>
    internal void PublishNewest(string topic, IRosMessage message) => _hub.PublishNewest(this, new HubMessage(topic, message, this, Now));

    /// <summary>Whether none of these joints of a robot belongs to another source.</summary>
    internal bool MayPublish(string robot, string[] names) => _hub.IsFree(this, robot, names);

    /// <summary>Whether a frame or signal does not belong to another source.</summary>
    /// <param name="kind"><see cref="CellKinds.Frame"/> or <see cref="CellKinds.Signal"/>.</param>
    internal bool MayPublishPart(string kind, string name) => OtherOwner(kind, name) == null;

    /// <summary>Gets the other source that owns a frame or signal; null if there is none.</summary>
    /// <inheritdoc cref="MayPublishPart" path="/param"/>
    internal HubSource OtherOwner(string kind, string name) => _hub.OtherOwner(this, kind, name);

    /// <summary>Reports a sample that was dropped because of its content.</summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="names">The joints named in the sample, as far as they can be read.</param>
    internal void ReportDropped(string robot, string[] names, string reason, DropReason code) =>
        _hub.ReportDropped(this, robot, names, reason, code);

    /// <summary>Reports set-points that were refused for another reason than their owner, which the hub reports itself.</summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="joint">The first joint of the message; empty if no name can be read.</param>
    internal void ReportRefused(string robot, string joint, Refusal refusal) =>
        _hub.ReportRefused(this, RobotTopic.NameOf(robot, RosTopics.JointTrajectory), joint, refusal);

    /// <summary>Reports a rule that the client breaks.</summary>
    /// <param name="what">What the client does, as a predicate, for example <see cref="EventTexts.ExceedsRate"/>.</param>
    /// <param name="rule">The rule with the allowed values and the remedy, as a clause.</param>
    internal void ReportBrokenRule(string what, string rule) => _hub.ReportBrokenRule(this, what, rule);

    /// <summary>Reports a frame or a signal that was left out of a message.</summary>
    /// <param name="topic">Topic of the message.</param>
    internal void ReportDropped(string topic, LeftOut part) => _hub.ReportDropped(this, topic, part);

    /// <summary>Reports that the source ends normally. Its data are then removed from the status after a period without messages.</summary>
    /// <param name="topic">The topic on which it ends; null for all.</param>
    internal void Leave(string topic = null) => _hub.ReportLeft(this, topic);

    /// <summary>Releases the joints, frames or signals that this source owns on one topic.</summary>
    public void Release(string topic)
    {
        _claimed.Clear();
        if (topic == null) _refused.Clear();
        else if (RobotTopic.Parse(topic) is { Kind: RosTopics.RobotDescription } described) _refused.Remove(described.Robot);
        _hub.Release(this, topic);
    }

    public void Dispose()
    {
        IsEnded = true;
        Release(null);
    }

    long Now => _hub.Time.GetTimestamp();

    // Whether the names take up half of the maximum length, so that they may not fit in one message with the numbers of each joint.
    static bool AreLong(string[] names) => names.Sum(RosMessageWriter.MaxBytesOf) > ProtocolLimits.MessageBytes / 2;

    /// <summary>Gets the cell-wide names of a robot's joints. Returns the same array for a robot without a namespace.</summary>
    internal static string[] InCell(string robot, string[] names) =>
        robot.Length == 0 ? names : Array.ConvertAll(names, name => RobotTopic.Qualified(robot, name));
}
