using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using static Nowpose.Gateway.Rosbridge.RequestText;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Handles the requests of one client, without access to sockets. Not thread-safe.</summary>
sealed class RosbridgeSession : IDisposable
{
    readonly MessageHub _hub;
    readonly HubSource _source;
    readonly ServedClock _clock;
    readonly PlantTimeOffers _offers;
    readonly MessagePublisher _publisher;
    readonly NamesInUse _names;
    readonly PublishRights _rights;
    readonly DropCounters _drops;
    readonly Action<ReadOnlyMemory<byte>> _reply;
    readonly SubscriptionSet _subscriptions;
    readonly RosbridgeReader _reader = new();
    readonly PartialCellMessage _partial = new();
    readonly StatusReplies _replies;
    readonly HashSet<string> _advertised = [];
    RosTimeForm _form;
    bool _isRos2;
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
        _rights = new PublishRights(role);
        _drops = drops;
        _reply = reply;
        _subscriptions = new SubscriptionSet(hub, queueLength, drops, start);
        _offers = new PlantTimeOffers(plant, _source, hub.Time, reply);
        _replies = new StatusReplies(_source, drops, _rights, Reply);
        _publisher = new MessagePublisher(_source, clock, _offers);
    }

    /// <summary>Sets the client's address, which messages contain if the client has no name.</summary>
    public string Address { set => _source.Address = value; }

    /// <inheritdoc cref="PlantTimeOffers.IsOwnAdapter"/>
    public bool IsOwnAdapter { set => _offers.IsOwnAdapter = value; }

    /// <summary>
    /// Removes the status that the client has reported. Call this method before <see cref="Dispose"/> if the client closed the connection normally.
    /// </summary>
    public void Leave()
    {
        if (_name != null && _names.Release(_name, this)) _hub.ReportLeft(_name);
        _source.Leave();
    }

    /// <summary>Maximum number of messages that the client may send per second, for messages about drops.</summary>
    public int MaxMessagesPerSecond { get; init; }

    public void Handle(in Received received)
    {
        _receivedAt = received.Count;
        _text = _replies.Received = received.Utf8;
        _offers.TryAgain();
        var message = default(RosbridgeMessage);
        var reason = received.Fault;
        if (reason == DropReason.None && _reader.TryRead(_text.Span, out message, out reason))
            Do(message, received.Count);
        else if (message is { Op: RosbridgeOp.Publish } && Publications.HasParts(message.Topic) && _rights.On(message.RobotTopic) == DropReason.None)
            PublishValidParts(message, reason);
        else
            _replies.Drop(message, reason, rule: reason == DropReason.TooManyMessages ? DropMessages.TooManyMessages(MaxMessagesPerSecond) : null);
    }

    public void Dispose()
    {
        _offers.Dispose();
        _subscriptions.Dispose();
        _source.Dispose();
        if (_name != null) _names.Release(_name, this);
    }

    void Do(RosbridgeMessage message, long count)
    {
        if (message.Topic?.StartsWith('/') == false && message.Op is RosbridgeOp.Subscribe or RosbridgeOp.Unsubscribe or RosbridgeOp.Advertise
            or RosbridgeOp.Unadvertise or RosbridgeOp.Publish)
        {
            _replies.Drop(message, DropReason.UnknownTopic, rule: RequestMessages.NoSlash(Short(message.Topic)));
            return;
        }

        if (message.RobotTopic is { IsValid: false } && message.Op is RosbridgeOp.Subscribe or RosbridgeOp.Advertise or RosbridgeOp.Publish)
        {
            _replies.Drop(message, DropReason.InvalidNamespace);
            return;
        }

        switch (message.Op)
        {
            case RosbridgeOp.Subscribe: Subscribe(message); break;
            case RosbridgeOp.Unsubscribe: Unsubscribe(message); break;
            case RosbridgeOp.Advertise: Advertise(message); break;
            case RosbridgeOp.Unadvertise: Unadvertise(message); break;
            case RosbridgeOp.Publish: Publish(message); break;
            case RosbridgeOp.CallService: Call(message); break;
            case RosbridgeOp.AdvertiseService: Offer(message); break;
            case RosbridgeOp.UnadvertiseService: _offers.Withdraw(message.Service); break;
            case RosbridgeOp.ServiceResponse: _offers.Answer(message, count); break;
            case RosbridgeOp.Status: break;
            case RosbridgeOp.SetLevel: SetLevel(message); break;
            default: _replies.Drop(message, DropReason.UnknownOp); break;
        }
    }

    void SetLevel(RosbridgeMessage message)
    {
        if (message.Level is "info" or "warning" or "error" or "none") _replies.Level = message.Level;
        else _replies.Warn(message, RequestMessages.Level(Short(message.Level)));
    }

    void Subscribe(RosbridgeMessage message)
    {
        if (Publications.IsKnown(message.RobotTopic) && !Publications.HasType(message.RobotTopic, message.Type))
        {
            _replies.Drop(message, DropReason.WrongType, rule: TypeRule(message));
            return;
        }

        if (!HasRoomFor(message) || !HasRoomForId(message))
            return;
        Warn(message);
        if (!Publications.IsKnown(message.RobotTopic))
            _replies.Warn(message, RequestMessages.NotPublished(Topics));
        Remember(message.Type);
        var terms = SubscriptionTerms.Of(message);
        var form = _subscriptions.Add(message.Topic, message.Id, terms);
        if (form != terms.Form) _replies.Warn(message, RequestMessages.OtherTimeForm(form));
    }

    void Unsubscribe(RosbridgeMessage message)
    {
        if (!_subscriptions.Remove(message.Topic, message.Id))
            _replies.Warn(message, RequestMessages.NotSubscribed(_subscriptions.Topics.Contains(message.Topic) ? $"{Short(message.Id)}" : null));
    }

    void Advertise(RosbridgeMessage message)
    {
        var reason = _rights.On(message.RobotTopic);
        if (reason == DropReason.None && !Publications.HasType(message.RobotTopic, message.Type))
            reason = DropReason.WrongType;
        if (reason != DropReason.None)
            _replies.Drop(message, reason, rule: reason == DropReason.WrongType ? TypeRule(message) : null);
        else if (HasRoomFor(message))
            Reserve(message);
        if (reason != DropReason.None) return;
        Warn(message);
        Remember(message.Type);
    }

    void Reserve(RosbridgeMessage message)
    {
        if (_source.Use(message.RobotTopic) is { } refusal) _replies.Drop(message, refusal);
        else _advertised.Add(message.Topic);
    }

    void Unadvertise(RosbridgeMessage message)
    {
        if (!_advertised.Remove(message.Topic))
        {
            _replies.Warn(message, RequestMessages.NotAdvertised);
            return;
        }

        // Before the release, which reports the dropped poses of the next source.
        if (message.RobotTopic.Kind == RosTopics.JointStates || Publications.HasParts(message.Topic)) _source.Leave(message.Topic);
        _source.Release(message.Topic);
    }

    void Offer(RosbridgeMessage message)
    {
        var rule = default(string);
        var reason = _rights.MayOfferTime ? _offers.Offer(message.Service, out rule) : DropReason.NotAllowed;
        if (reason != DropReason.None) _replies.Drop(message, reason, rule);
    }

    void Publish(RosbridgeMessage message)
    {
        var reason = _rights.On(message.RobotTopic);
        ControlTime stamp = default;
        if (reason == DropReason.None && (reason = _publisher.Judge(message, out stamp)) != DropReason.None && _publisher.LeftOut.Count == 0)
            _publisher.LeftOut.AddRange(Publications.PartsOf(message).Select(part =>
                new LeftOut(reason, part, CellMessageFaults.Named(CellKinds.Of(message.Topic), part) + ": " + _publisher.TextOf(reason))));
        var name = Publications.NameIn(message);
        if (reason == DropReason.None && name != null && !_rights.MayUse(name))
            reason = DropReason.NotAllowed;
        if (reason != DropReason.None)
        {
            DropWhole(message, reason);
            if (reason == DropReason.StampInFuture) _publisher.AddStamp(message, stamp, true);
            return;
        }

        var refusal = RefuseName(name) ?? _publisher.Publish(message, stamp, _receivedAt);
        if (refusal != null) _replies.Drop(message, refusal.Value);
        if (refusal == null && _publisher.Warning is { } warning) _replies.Warn(message, warning);
        if (refusal is null or { IsPartial: true }) _publisher.AddStamp(message, stamp, false);
        if (Unsupported.MayBeIn(_text.Span, message)) Warn(message);
        _replies.DropParts(message, _publisher.LeftOut);
    }

    // The first name that a client uses becomes its name.
    Refusal? RefuseName(string name)
    {
        if (name == null) return null;
        if (name != (_name ??= name))
            return new Refusal(DropReason.NotAllowed, $"the name {Short(name)}", Rule: RequestMessages.OneName(Short(_name)));
        if (_names.TryUse(name, this)) return null;
        _hub.ReportNameRefused(_source, name);
        return new Refusal(DropReason.JointTaken, $"the name {Short(name)}");
    }

    // Publishes the valid transforms or signals of a message that also contains invalid ones.
    void PublishValidParts(RosbridgeMessage message, DropReason reason)
    {
        if (_partial.TryRead(_text.Span, message, _publisher.LeftOut)) Publish(message);
        else DropWhole(message, reason);
    }

    // Reports a message that is not published at all. It is one drop, although several transforms or signals may be invalid.
    void DropWhole(RosbridgeMessage message, DropReason reason)
    {
        foreach (var part in _publisher.LeftOut) _source.ReportDropped(message.Topic, part);
        _replies.Drop(message, reason, rule: _publisher.LeftOut.Find(part => part.Reason == reason).Fault ?? _publisher.TextOf(reason));
        _publisher.LeftOut.Clear();
    }

    void Call(RosbridgeMessage message)
    {
        Warn(message);
        switch (Absolute(message.Service))
        {
            case RosTopics.GetTime: Reply(RosbridgeWriter.TimeResponse(message.Service, message.Id, _clock.Now, _form)); break;
            case RosTopics.GetTopics: Reply(RosbridgeWriter.TopicsResponse(message.Service, message.Id, [.. Rosapi.Types(_isRos2, _hub)])); break;
            case var service when Rosapi.Call(service, _text, _isRos2, _hub) is { } values:
                Reply(RosbridgeWriter.ServiceResponse(message.Service, message.Id, values));
                break;
            default:
                _drops.Count(DropReason.UnknownService);
                Reply(RosbridgeWriter.FailedResponse(message.Service, message.Id, DropMessages.Of(DropReason.UnknownService)));
                break;
        }
    }

    // Returns the name of a service with a slash. As in rosbridge, a name without a slash is relative to the root; roslib uses such names.
    static string Absolute(string name) => name.StartsWith('/') ? name : "/" + name;

    bool HasRoomFor(RosbridgeMessage message)
    {
        var topics = new HashSet<string>(_subscriptions.Topics.Concat(_advertised)) { message.Topic };
        var isNameGood = message.Topic.Length <= ProtocolLimits.NameLength;
        if (!isNameGood || topics.Count > ProtocolLimits.TopicsPerClient)
            _replies.Drop(message, isNameGood ? DropReason.TooManyTopics : DropReason.NameTooLong);
        return isNameGood && topics.Count <= ProtocolLimits.TopicsPerClient;
    }

    bool HasRoomForId(RosbridgeMessage message)
    {
        var isIdGood = !(message.Id.Text?.Length > ProtocolLimits.KeyLength);
        if (isIdGood && _subscriptions.HasRoomFor(message.Topic, message.Id)) return true;
        if (isIdGood) _replies.Drop(message, DropReason.TooManyTopics, rule: DropMessages.TooManySubscriptions);
        else _replies.Drop(message, DropReason.NameTooLong, rule: DropMessages.IdTooLong);
        return false;
    }

    // Derives the client's ROS version from the newest type name that it has sent, for responses of services, whose requests contain no type.
    void Remember(string type)
    {
        if (string.IsNullOrEmpty(type)) return;
        _form = RosTopics.TimeFormOf(type);
        _isRos2 = _form == RosTimeForm.Sec;
    }

    // Warns of each unsupported option. The request is served without these options.
    void Warn(RosbridgeMessage message)
    {
        foreach (var unsupported in Unsupported.In(_text.Span, message)) _replies.Warn(message, unsupported);
    }

    void Reply(string text) => _reply(Encoding.UTF8.GetBytes(text));
}
