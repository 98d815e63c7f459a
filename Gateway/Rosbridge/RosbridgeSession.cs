using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Handles the requests of one client, without access to sockets. Called by one thread at a time.</summary>
sealed class RosbridgeSession : IDisposable
{
    const string Operations = "subscribe, unsubscribe, advertise, unadvertise, publish, call_service, advertise_service, unadvertise_service, "
        + "service_response, status, set_level";

    static readonly string Topics = string.Join(", ", Publications.All.Select(topic => topic.Key));

    readonly MessageHub _hub;
    readonly HubSource _source;
    readonly ServedClock _clock;
    readonly PlantTimeOffers _offers;
    readonly NamesInUse _names;
    readonly Role _role;
    readonly DropCounters _drops;
    readonly Action<ReadOnlyMemory<byte>> _reply;
    readonly SubscriptionSet _subscriptions;
    readonly RosbridgeReader _reader = new();
    readonly HashSet<string> _advertised = [];
    RosTimeForm _form;
    bool _isRos2;
    string _level;
    ReadOnlyMemory<byte> _text;
    string _name;
    long _receivedAt;

    public RosbridgeSession(
        MessageHub hub, ServedClock clock, PlantClocks plant, NamesInUse names, Role role, DropCounters drops, int queueLength,
        Action<ReadOnlyMemory<byte>> reply, Action<Subscription> start)
    {
        _hub = hub;
        _source = hub.OpenSource();
        _source.Name = HubSource.Unnamed;
        _clock = clock;
        _names = names;
        _role = role;
        _drops = drops;
        _reply = reply;
        _subscriptions = new SubscriptionSet(hub, queueLength, drops, start);
        _offers = new PlantTimeOffers(plant, reply);
    }

    /// <summary>Address of the client, for messages about a client without a name.</summary>
    public string Address
    {
        set => _source.Address = value;
    }

    /// <summary>
    /// Removes the state that the client reported of itself, because it closed the connection normally. Call it before <see cref="Dispose"/>.
    /// </summary>
    public void Leave()
    {
        if (_name != null && _names.Release(_name, this)) _hub.ReportLeft(_name);
        _source.Leave();
    }

    public void Handle(in Received received)
    {
        _receivedAt = received.Count;
        _text = received.Utf8;
        _offers.TryAgain();
        var message = default(RosbridgeMessage);
        var reason = received.Fault;
        if (reason == DropReason.None && _reader.TryRead(_text.Span, out message, out reason))
            Do(message, received.Count);
        else
            Drop(message, reason);
    }

    public void Dispose()
    {
        _offers.Dispose();
        _subscriptions.Dispose();
        _source.Dispose();
        if (_name != null)
            _names.Release(_name, this);
    }

    void Do(RosbridgeMessage message, long count)
    {
        if (message.Topic?.StartsWith('/') == false && message.Op is RosbridgeOp.Subscribe or RosbridgeOp.Advertise or RosbridgeOp.Publish)
        {
            Drop(message, DropReason.UnknownTopic, rule: $"a topic name begins with a slash: /{Short(message.Topic)}");
            return;
        }

        switch (message.Op)
        {
            case RosbridgeOp.Subscribe: Subscribe(message); break;
            case RosbridgeOp.Unsubscribe: _subscriptions.Remove(message.Topic, message.Id); break;
            case RosbridgeOp.Advertise: Advertise(message); break;
            case RosbridgeOp.Unadvertise: Unadvertise(message); break;
            case RosbridgeOp.Publish: Publish(message); break;
            case RosbridgeOp.CallService: Call(message); break;
            case RosbridgeOp.AdvertiseService: Offer(message); break;
            case RosbridgeOp.UnadvertiseService: _offers.Withdraw(message.Service); break;
            case RosbridgeOp.ServiceResponse: _offers.Answer(message, count); break;
            case RosbridgeOp.Status: break;
            case RosbridgeOp.SetLevel: _level = message.Level; break;
            default: Drop(message, DropReason.UnknownOp); break;
        }
    }

    void Subscribe(RosbridgeMessage message)
    {
        if (Publications.IsKnown(message.Topic) && !Publications.HasType(message.Topic, message.Type))
        {
            Drop(message, DropReason.WrongType, rule: TypeRule(message));
            return;
        }

        if (!HasRoomFor(message))
            return;
        Warn(message);
        if (!Publications.IsKnown(message.Topic))
            Warn(message, $"receives no messages, because the gateway never publishes this topic. Its topics: {Topics}");
        Remember(message.Type);
        _subscriptions.Add(message.Topic, message.Id, SubscriptionTerms.Of(message));
    }

    void Advertise(RosbridgeMessage message)
    {
        var reason = Allowance(message.Topic);
        if (reason == DropReason.None && !Publications.HasType(message.Topic, message.Type))
            reason = DropReason.WrongType;
        if (reason != DropReason.None)
            Drop(message, reason, rule: reason == DropReason.WrongType ? TypeRule(message) : null);
        else if (HasRoomFor(message))
            _advertised.Add(message.Topic);
        Remember(message.Type);
    }

    static string TypeRule(RosbridgeMessage message) =>
        $"{message.Topic} has the type {Publications.TypeOf(message.Topic)}, not {Short(message.Type)}";

    void Unadvertise(RosbridgeMessage message)
    {
        if (!_advertised.Remove(message.Topic)) return;
        _source.Release(message.Topic);
        if (message.Topic == RosTopics.JointStates) _source.Leave();
    }

    void Offer(RosbridgeMessage message)
    {
        var reason = _role == Role.Source ? _offers.Offer(message.Service) : DropReason.NotAllowed;
        if (reason != DropReason.None)
            Drop(message, reason, reason == DropReason.JointTaken ? "the clock" : null);
    }

    void Publish(RosbridgeMessage message)
    {
        var reason = Allowance(message.Topic);
        var stamp = Publications.StampOf(message) ?? default;
        if (reason == DropReason.None && stamp != default)
            reason = Judge(ref stamp);
        var name = Publications.NameIn(message);
        if (reason == DropReason.None && name != null && !IsOwn(name))
            reason = DropReason.NotAllowed;
        if (reason != DropReason.None)
        {
            Drop(message, reason);
            if (reason == DropReason.StampInFuture) AddStamp(message, stamp, true);
            return;
        }

        var taken = name == null || _names.TryUse(name, this) ? Hand(message, stamp) : $"the name {Short(name)}";
        if (taken != null)
            Drop(message, DropReason.JointTaken, taken);
        else
            AddStamp(message, stamp, false);
    }

    // A source whose joints belong to another one is not evidence about the stamps of this cell.
    void AddStamp(RosbridgeMessage message, ControlTime stamp, bool isRefused)
    {
        if (message.JointState is not { } state || stamp == default || _offers.StampClock != null) return;
        // For an accepted sample, the hub has already checked this.
        if (!isRefused || _source.MayPublish(state.Names)) _clock.Stamps.Add(_source, stamp, isRefused);
    }

    // Maps stamps of another clock of the plant to C1.
    DropReason Judge(ref ControlTime stamp)
    {
        if (!_clock.TryMap(_offers.StampClock, stamp, out stamp))
            return DropReason.Unsynchronised;
        return StampRule.IsInFuture(stamp, _clock.Now, _clock.ErrorBound) ? DropReason.StampInFuture : DropReason.None;
    }

    // Publishes the message. Returns null on success, otherwise the joint or topic that belongs to another source.
    string Hand(RosbridgeMessage message, ControlTime stamp)
    {
        if (message.JointState is { } state)
            return _source.TryPublish(state.Stamp == stamp ? state : state.At(stamp), _receivedAt);
        if (message.JointTrajectory is { } plan)
            return _source.TryPublish(plan.Stamp == stamp ? plan : plan.At(stamp), _receivedAt);
        if (message.Data != null)
            return _source.TryDescribe(message.Data);
        if (message.Displayed != null)
            _source.PublishDisplayed(message.Displayed);
        else
            _source.Publish(message.Diagnostics);
        return null;
    }

    // The first name that a client uses is its name. An observer must not use the name of a plant.
    bool IsOwn(string name)
    {
        if (_role != Role.Source && StatusObjects.IsAdapter(name))
            return false;
        return name == (_name ??= name);
    }

    void Call(RosbridgeMessage message)
    {
        Warn(message);
        switch (Absolute(message.Service))
        {
            case RosTopics.GetTime: Reply(RosbridgeWriter.TimeResponse(message.Service, message.Id, _clock.Now, _form)); break;
            case RosTopics.GetTopics: Reply(RosbridgeWriter.TopicsResponse(message.Service, message.Id, [.. Rosapi.Types(_isRos2)])); break;
            case var service when Rosapi.Call(service, _text, _isRos2, _hub) is { } values:
                Reply(RosbridgeWriter.ServiceResponse(message.Service, message.Id, values));
                break;
            default:
                _drops.Count(DropReason.UnknownService);
                Reply(RosbridgeWriter.FailedResponse(message.Service, message.Id, DropText.Of(DropReason.UnknownService)));
                break;
        }
    }

    // A name without a slash is relative to the root, where rosbridge's own node is. roslib uses this form for rosapi services.
    static string Absolute(string name) => name.StartsWith('/') ? name : "/" + name;

    DropReason Allowance(string topic)
    {
        if (!Publications.IsOpen(topic))
            return _role == Role.Source ? DropReason.UnknownTopic : DropReason.NotAllowed;
        return _role == Role.Source || Publications.IsOfItself(topic) ? DropReason.None : DropReason.NotAllowed;
    }

    bool HasRoomFor(RosbridgeMessage message)
    {
        var topics = new HashSet<string>(_subscriptions.Topics.Concat(_advertised)) { message.Topic };
        var isNameGood = message.Topic.Length <= ProtocolLimits.NameLength;
        if (!isNameGood || topics.Count > ProtocolLimits.TopicsPerClient)
            Drop(message, isNameGood ? DropReason.TooManyTopics : DropReason.NameTooLong);
        return isNameGood && topics.Count <= ProtocolLimits.TopicsPerClient;
    }

    // The newest type that a client names shows its ROS version; responses of services name none.
    void Remember(string type)
    {
        if (string.IsNullOrEmpty(type)) return;
        _form = RosTopics.TimeFormOf(type);
        _isRos2 = _form == RosTimeForm.Sec;
    }

    // The request is served, but without an unsupported option.
    void Warn(RosbridgeMessage message)
    {
        if (Unsupported.In(_text) is { } unsupported) Warn(message, unsupported);
    }

    void Warn(RosbridgeMessage message, string text)
    {
        if (_level is not ("none" or "error")) Reply(RosbridgeWriter.Status("warning", Subject(message) + text, Short(message.Id)));
    }

    void Drop(RosbridgeMessage message, DropReason reason, string what = null, string rule = null)
    {
        _drops.Count(reason);
        rule ??= what == null ? DropText.Of(reason) : $"{what} {DropText.Of(reason)}";
        var text = reason == DropReason.UnknownOp
            ? $"Unknown operation: {Short(message.OpName)}. Allowed operations: {Operations}"
            : $"{Subject(message)}dropped: {rule} ({reason})";
        if (_level != "none")
            Reply(RosbridgeWriter.Status("error", text, Short(message?.Id)));
        // The joint board handles joints of other sources itself.
        if (message is { Op: RosbridgeOp.Publish, Topic: RosTopics.JointStates } && reason != DropReason.JointTaken)
            ReportDropped(message.JointState, rule, reason);
    }

    void ReportDropped(JointStateMessage valid, string rule, DropReason reason)
    {
        var (names, trouble) = valid == null ? InvalidJointState.Read(_text.Span) : (valid.Names, null);
        _source.ReportDropped(names, $"the gateway drops the samples of {_source.Title}: {trouble ?? rule} ({reason})");
    }

    static string Subject(RosbridgeMessage message) =>
        string.Concat(new[] { message?.OpName, message?.Topic ?? message?.Service }.Where(part => !string.IsNullOrEmpty(part)).Select(part => $"{Short(part)} "));

    // Replies repeat at most the maximum length of a name.
    static string Short(string text) =>
        text?.Length > ProtocolLimits.NameLength ? string.Concat(text.AsSpan(0, ProtocolLimits.NameLength - 1), "…") : text;

    void Reply(string text) => _reply(Encoding.UTF8.GetBytes(text));
}
