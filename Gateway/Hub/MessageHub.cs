using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>Distributes messages from sources to subscribers. Thread-safe; publishing never waits for a subscriber.</summary>
public sealed class MessageHub
{
    readonly Lock _lock = new();
    readonly JointOwners _owners = new();
    readonly Subscribers _subscribers = new();
    readonly Dictionary<(HubSource Source, string Topic), HubMessage> _newest = [];
    readonly RobotRegistry _robots = new();
    readonly CellSignals _signals;
    long _sequence;

    /// <param name="time">Time source of the hub and its clients; null for the system's.</param>
    public MessageHub(TimeProvider time = null)
    {
        Time = time ?? TimeProvider.System;
        Forwarding = new ForwardingTimes(Time);
        Frames = new CellFrames(Links, Samples, Time, PublishNumbered, ReportDropped);
        Links.Changed += (_, _) => Exclusively(Frames.RemoveCycles);
        _signals = new CellSignals(
            Time, PublishNumbered, names => SignalsBegan?.Invoke(names), (source, names) => SignalsEnded?.Invoke(source, names));
    }

    internal TimeProvider Time { get; }

    /// <summary>Number of topics with at least one subscriber.</summary>
    internal int Topics => _subscribers.Topics;

    /// <summary>The namespaces of the robots that have one.</summary>
    internal IReadOnlyList<string> Robots
    {
        get { lock (_lock) return [.. _robots.Names]; }
    }

    /// <summary>The frames of the cell. Outside of the hub, only their events may be used.</summary>
    internal CellFrames Frames { get; }

    /// <summary>The descriptions and the links of the robots.</summary>
    internal RobotLinks Links { get; } = new();

    /// <summary>The newest joint states and moving poses. <see cref="Subscribe(string, Action{HubMessage})"/> does not pass them to a new subscriber.</summary>
    internal NewestSamples Samples { get; } = new();

    /// <summary>Times from the receipt of a joint state until it is written to a subscriber's socket.</summary>
    public ForwardingTimes Forwarding { get; }

    /// <summary>
    /// Raised when a joint, frame or signal of a source is refused because another source owns it, with the source, the topic, the name and the owner.
    /// Called under the hub's lock.
    /// </summary>
    internal event Action<HubSource, string, string, HubSource> Refused;

    /// <summary>
    /// Raised when set-points or an invalid description are refused, with the source, the topic, and the joint that is refused or the first one of
    /// the message; empty if no name can be read, and for a description. May be called under the hub's lock; must not wait.
    /// </summary>
    internal event Action<HubSource, string, string, Refusal> MessageRefused;

    /// <inheritdoc cref="JointOwners.RobotOfListedJoint"/>
    internal Func<string, string> RobotOfListedJoint { set => _owners.RobotOfListedJoint = value; }

    /// <summary>Raised when a frame or signal is left out for another reason than its owner. Called under the hub's lock.</summary>
    internal event Action<HubSource, string, LeftOut> PartDropped;

    /// <summary>
    /// Raised when a sample is dropped because of its content, with its source, its joints and the reason as a sentence and as a code. Not raised
    /// for a sample that names a joint of another source.
    /// </summary>
    internal event Action<HubSource, string[], string, DropReason> SampleDropped;

    /// <summary>Raised when the report of a client is refused because another client uses the name in it.</summary>
    internal event Action<HubSource, string> NameRefused;

    /// <summary>Raised when a client breaks a rule, with what it does as a predicate, and the rule as a clause.</summary>
    internal event Action<HubSource, string, string> RuleBroken;

    /// <summary>Raised with the name of a client that has closed its connection normally.</summary>
    internal event Action<string> Left;

    /// <summary>Raised when a source no longer publishes on a topic, except when it ends. Called under the hub's lock.</summary>
    internal event Action<HubSource, string> TopicReleased;

    /// <summary>Raised when a source ends normally, with the topic that it has unadvertised, or null if it has closed its connection.</summary>
    internal event Action<HubSource, string> SourceLeft;

    /// <summary>Gets the description of a robot; null until a source has published one.</summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    internal string DescriptionOf(string robot) => Links.Described.GetValueOrDefault(robot)?.Urdf;

    /// <summary>Raised when a source starts to publish signals that have no source yet. Called under the hub's lock.</summary>
    internal event Action<IReadOnlyCollection<string>> SignalsBegan;

    /// <summary>Raised when a source of signals has ended or has unadvertised the signals. Called under the hub's lock.</summary>
    internal event Action<HubSource, IReadOnlyCollection<string>> SignalsEnded;

    /// <summary>Calls an action under the hub's lock. No signal gains or loses its source during the call.</summary>
    internal void Exclusively(Action action)
    {
        lock (_lock) action();
    }

    /// <summary>Creates a publisher. A joint belongs to its first source, until that source releases the joint or is disposed.</summary>
    public HubSource OpenSource() => new(this);

    /// <summary>Subscribes to a topic: passes the kept messages at once, and all later messages when they are published.</summary>
    /// <remarks>
    /// The kept messages are the robot description, each source's newest set-points, stationary frames, signals, the lists of joints and signals
    /// without current data, and the version of the gateway.
    /// </remarks>
    /// <param name="topic">The topic, with the robot's namespace.</param>
    /// <param name="receive">Called on the publisher's thread; must not block.</param>
    public IDisposable Subscribe(string topic, Action<HubMessage> receive)
    {
        lock (_lock)
        {
            var subscriber = SubscribeToNew(topic, receive);
            foreach (var message in Kept(topic)) receive(message);
            return subscriber;
        }
    }

    /// <summary>Subscribes to a topic without its kept messages. The caller can get latched messages from <see cref="ReadLatched"/>.</summary>
    internal IDisposable SubscribeToNew(string topic, Action<HubMessage> receive)
    {
        // Under the lock, so that a message kept in the meantime is received exactly once.
        lock (_lock) return _subscribers.Add(topic, receive);
    }

    /// <summary>Subscribes to one topic of all robots that have a namespace. Kept messages are not passed.</summary>
    /// <param name="kind">/joint_states, /joint_trajectory or /robot_description.</param>
    internal IDisposable SubscribeToRobots(string kind, Action<HubMessage> receive) => SubscribeToNew(Subscribers.OfAllRobots(kind), receive);

    /// <summary>Gets the current values of a latched topic, in the order of publication. During the call, no message is published on it.</summary>
    /// <param name="since">Called first, under the lock; returns the sequence number of the first message to read.</param>
    /// <inheritdoc cref="LatchedMessages.Since" path="/param[@name='changesAfter']"/>
    internal IEnumerable<HubMessage> ReadLatched(string topic, Func<long> since, Func<string, long> changesAfter = null)
    {
        lock (_lock) return (topic == RosTopics.Signals ? _signals.Newest : Frames.Stationary).Since(since(), changesAfter ?? (_ => long.MaxValue));
    }

    /// <inheritdoc cref="CellFrames.Applicable"/>
    internal HubMessage Applicable(HubMessage message)
    {
        lock (_lock) return Frames.Applicable(message);
    }

    internal void Publish(HubMessage message) => _subscribers.Publish(message);

    internal bool Publish(HubSource source, TransformsMessage message, bool isStationary, List<LeftOut> leftOut, long receivedAt)
    {
        // Under the lock for the same reason as Describe, and so that no pose of a frame is published after its release.
        lock (_lock) return Frames.Publish(source, message, isStationary, leftOut, receivedAt);
    }

    internal bool Publish(HubSource source, SignalsMessage message, List<LeftOut> leftOut, long receivedAt)
    {
        lock (_lock) return _signals.Publish(source, message, leftOut, receivedAt);
    }

    /// <summary>Publishes a robot description, unless another source has published one, or it is invalid and the robot has a valid one.</summary>
    internal Refusal? Describe(HubSource source, HubMessage message, DescribedRobot described)
    {
        // Not under the lock, because this parses the description.
        var isValid = described.Fault == null;
        // Under the lock, so that a new subscriber receives the message exactly once, either as the kept message or as a new one.
        lock (_lock)
        {
            var (robot, kind) = (message.Robot, RosTopics.RobotDescription);
            Refusal? invalid = isValid || Links.Described.GetValueOrDefault(robot)?.Model == null ? null
                : new Refusal(DropReason.NotUrdf, DropMessages.KeptDescription, Rule: described.Fault);
            var refusal = _owners.Claim(source, robot, kind, ["the robot"], () => invalid ?? Use(source, robot, kind), out _, out _);
            if (refusal != null) return refusal;
            _robots.Describe(message);
            Links.Describe(robot, described);
            Publish(message);
            return null;
        }
    }

    /// <summary>Publishes a message and keeps it for later subscribers, until its source ends or publishes the next message on the topic.</summary>
    internal void PublishNewest(HubSource source, HubMessage message)
    {
        // Under the lock for the same reason as Describe.
        lock (_lock)
        {
            _newest[(source, message.Topic)] = message;
            Publish(message);
        }
    }

    /// <summary>Records that a source publishes on a topic of a robot.</summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <returns>A refusal if there are too many robots; otherwise null.</returns>
    internal Refusal? Use(HubSource source, string robot, string kind)
    {
        lock (_lock)
        {
            var hasRoom = _robots.TryUse(robot, source, RobotTopic.NameOf(robot, kind), out var removed);
            if (removed != null) Links.Remove(removed);
            return hasRoom ? null : new Refusal(DropReason.TooManyRobots, $"robot {robot}");
        }
    }

    /// <inheritdoc cref="JointOwners.Claim" path="/summary|/returns|/param[@name='robot' or @name='claimed']"/>
    internal Refusal? Claim(HubSource source, string robot, string kind, string[] names, out string[] claimed)
    {
        lock (_lock)
        {
            var refusal = _owners.Claim(source, robot, kind, names, () => Use(source, robot, kind), out claimed, out var taken);
            foreach (var one in claimed.Length == 0 ? taken.Take(1) : taken)
                if (kind == RosTopics.JointTrajectory) ReportRefused(source, RobotTopic.NameOf(robot, kind), one.What, one);
                else if (one.Owner is { } owner)
                    Refused?.Invoke(source, kind, RobotTopic.Qualified(robot, one.What), owner);
            return refusal;
        }
    }

    internal bool IsFree(HubSource source, string robot, string[] names)
    {
        lock (_lock) return _owners.FindTaken(source, RobotTopic.NameOf(robot, RosTopics.JointStates), names) == null;
    }

    /// <summary>Gets the other source that owns a frame or signal; null if there is none.</summary>
    /// <param name="kind"><see cref="CellKinds.Frame"/> or <see cref="CellKinds.Signal"/>.</param>
    internal HubSource OtherOwner(HubSource source, string kind, string name)
    {
        lock (_lock) return (kind == CellKinds.Signal ? _signals.Owners : Frames.Owners).OtherThan(source, name);
    }

    internal void ReportNameRefused(HubSource source, string name) => NameRefused?.Invoke(source, name);
    internal void ReportBrokenRule(HubSource source, string what, string rule) => RuleBroken?.Invoke(source, what, rule);
    internal void ReportLeft(string name) => Left?.Invoke(name);
    internal void ReportLeft(HubSource source, string topic) => SourceLeft?.Invoke(source, topic);
    internal void ReportRefused(HubSource source, string topic, string joint, Refusal why) => MessageRefused?.Invoke(source, topic, joint, why);

    internal void ReportDropped(HubSource source, string robot, string[] names, string reason, DropReason code)
    {
        lock (_lock)
        {
            // The hub would have refused even a valid sample, so the fault does not concern the joints of the other source.
            if (_owners.FindTaken(source, RobotTopic.NameOf(robot, RosTopics.JointStates), names) is { } taken)
            {
                Refused?.Invoke(source, RosTopics.JointStates, RobotTopic.Qualified(robot, taken.What), taken.Owner);
                return;
            }
        }

        SampleDropped?.Invoke(source, HubSource.InCell(robot, names), reason, code);
    }

    internal void ReportDropped(HubSource source, string topic, LeftOut part)
    {
        lock (_lock)
        {
            if ((part.Owner ?? OtherOwner(source, CellKinds.Of(topic), part.Name)) is { } owner)
            {
                if (topic == RosTopics.TfStatic && part.Owner == null) Frames.KeepInvalid(source, part);
                Refused?.Invoke(source, topic, part.Name, owner);
            }
            else PartDropped?.Invoke(source, topic, part);
        }
    }

    internal void Release(HubSource source, string topic)
    {
        lock (_lock)
        {
            _owners.Release(source, topic);
            Samples.Release(source, topic);
            if (topic != null) TopicReleased?.Invoke(source, topic);
            foreach (var kept in _newest.Keys.Where(kept => kept.Source == source && (topic == null || kept.Topic == topic)).ToList())
                _newest.Remove(kept);
            if (topic is null or RosTopics.Tf or RosTopics.TfStatic) Frames.Release(source, topic);
            if (topic is null or RosTopics.Signals) _signals.Release(source);
            _robots.Release(source, topic);
        }
    }

    // Called under the lock.
    void PublishNumbered(HubMessage message) => Publish(message.With(++_sequence));

    // Called under the lock.
    IEnumerable<HubMessage> Kept(string topic)
    {
        if (CellKinds.IsLatched(topic)) return ReadLatched(topic, () => 0);
        return _robots.DescriptionOn(topic) is { } description ? [description] : [.. _newest.Values.Where(message => message.Topic == topic)];
    }
}
