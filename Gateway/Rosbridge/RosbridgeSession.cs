using System.Text;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>What one client asks and what becomes of it; knows no sockets. Called by one thread at a time.</summary>
sealed class RosbridgeSession : IDisposable
{
    const string Operations = "subscribe, unsubscribe, advertise, unadvertise, publish, call_service, status";

    readonly HubSource _source;
    readonly IControlClock _clock;
    readonly Role _role;
    readonly DropCounters _drops;
    readonly Action<ReadOnlyMemory<byte>> _reply;
    readonly SubscriptionSet _subscriptions;
    readonly HashSet<string> _advertised = [];
    RosTimeForm _form;
    string _hardwareId;

    public RosbridgeSession(
        MessageHub hub, IControlClock clock, Role role, DropCounters drops, int queueLength,
        Action<ReadOnlyMemory<byte>> reply, Action<Subscription> start)
    {
        _source = hub.OpenSource();
        _clock = clock;
        _role = role;
        _drops = drops;
        _reply = reply;
        _subscriptions = new SubscriptionSet(hub, queueLength, drops, start);
    }

    public void Handle(in Received received)
    {
        var message = default(RosbridgeMessage);
        var reason = received.Fault;
        if (reason == DropReason.None && RosbridgeReader.TryRead(received.Text, out message, out reason))
            Do(message);
        else
            Drop(message, reason);
    }

    public void Dispose()
    {
        _subscriptions.Dispose();
        _source.Dispose();
    }

    void Do(RosbridgeMessage message)
    {
        switch (message.Op)
        {
            case RosbridgeOp.Subscribe: Subscribe(message); break;
            case RosbridgeOp.Unsubscribe: _subscriptions.Remove(message.Topic, message.Id); break;
            case RosbridgeOp.Advertise: Advertise(message); break;
            case RosbridgeOp.Unadvertise: Unadvertise(message); break;
            case RosbridgeOp.Publish: Publish(message); break;
            case RosbridgeOp.CallService: Call(message); break;
            case RosbridgeOp.Status: break;
            default: Drop(message, DropReason.UnknownOp); break;
        }
    }

    void Subscribe(RosbridgeMessage message)
    {
        if (!HasRoomFor(message))
            return;
        Remember(message.Type);
        _subscriptions.Add(message.Topic, message.Id, SubscriptionTerms.Of(message));
    }

    void Advertise(RosbridgeMessage message)
    {
        var reason = Allowance(message.Topic);
        if (reason == DropReason.None && !Publications.HasType(message.Topic, message.Type))
            reason = DropReason.WrongType;
        if (reason != DropReason.None)
            Drop(message, reason);
        else if (HasRoomFor(message))
            _advertised.Add(message.Topic);
        Remember(message.Type);
    }

    void Unadvertise(RosbridgeMessage message)
    {
        if (_advertised.Remove(message.Topic))
            _source.Release(message.Topic);
    }

    void Publish(RosbridgeMessage message)
    {
        var reason = Allowance(message.Topic);
        if (reason == DropReason.None && Publications.StampOf(message) is { } stamp && StampRule.IsInFuture(stamp, _clock.Now, _clock.ErrorBound))
            reason = DropReason.StampInFuture;
        if (reason == DropReason.None && message.Diagnostics != null && !IsOwn(message.Diagnostics))
            reason = DropReason.NotAllowed;
        if (reason != DropReason.None)
        {
            Drop(message, reason);
            return;
        }

        var taken = Hand(message);
        if (taken != null)
            Drop(message, DropReason.JointTaken, taken);
    }

    // Returns what belongs to somebody else.
    string Hand(RosbridgeMessage message)
    {
        if (message.JointState != null)
            return _source.TryPublish(message.JointState);
        if (message.JointTrajectory != null)
            return _source.TryPublish(message.JointTrajectory);
        if (message.Data != null)
            return _source.TryDescribe(message.Data);
        _source.Publish(message.Diagnostics);
        return null;
    }

    // The first name a client gives is its name.
    bool IsOwn(DiagnosticsMessage diagnostics) => diagnostics.HardwareId == (_hardwareId ??= diagnostics.HardwareId);

    void Call(RosbridgeMessage message)
    {
        if (message.Service == RosTopics.GetTime)
        {
            Reply(RosbridgeWriter.TimeResponse(message.Service, message.Id, _clock.Now, _form));
            return;
        }

        _drops.Count(DropReason.UnknownService);
        Reply(RosbridgeWriter.FailedResponse(message.Service, message.Id, DropText.Of(DropReason.UnknownService)));
    }

    DropReason Allowance(string topic)
    {
        if (!Publications.IsKnown(topic))
            return _role == Role.Source ? DropReason.UnknownTopic : DropReason.NotAllowed;
        return _role == Role.Source || topic == RosTopics.Diagnostics ? DropReason.None : DropReason.NotAllowed;
    }

    bool HasRoomFor(RosbridgeMessage message)
    {
        var topics = new HashSet<string>(_subscriptions.Topics.Concat(_advertised)) { message.Topic };
        var isNameGood = message.Topic.Length <= ProtocolLimits.NameLength;
        if (!isNameGood || topics.Count > ProtocolLimits.TopicsPerClient)
            Drop(message, isNameGood ? DropReason.TooManyTopics : DropReason.NameTooLong);
        return isNameGood && topics.Count <= ProtocolLimits.TopicsPerClient;
    }

    // The newest type a client named tells which ROS it speaks; responses of services name none.
    void Remember(string type)
    {
        if (!string.IsNullOrEmpty(type))
            _form = RosTopics.TimeFormOf(type);
    }

    void Drop(RosbridgeMessage message, DropReason reason, string what = null)
    {
        _drops.Count(reason);
        var rule = what == null ? DropText.Of(reason) : $"{what} {DropText.Of(reason)}";
        var text = reason == DropReason.UnknownOp
            ? $"Unknown operation: {Short(message.OpName)}. Allowed operations: {Operations}"
            : $"{Subject(message)}dropped: {rule} ({reason})";
        Reply(RosbridgeWriter.Status("error", text, Short(message?.Id)));
    }

    static string Subject(RosbridgeMessage message) =>
        message == null ? "" : $"{Short(message.OpName)} {Short(message.Topic ?? message.Service)} ";

    // What is sent back is never longer than a name may be.
    static string Short(string text) =>
        text?.Length > ProtocolLimits.NameLength ? string.Concat(text.AsSpan(0, ProtocolLimits.NameLength - 1), "…") : text;

    void Reply(string text) => _reply(Encoding.UTF8.GetBytes(text));
}
