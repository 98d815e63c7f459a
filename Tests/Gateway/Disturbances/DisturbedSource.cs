using System.Text;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>A source that breaks all rules at times. Checks that the gateway publishes or counts each part of its messages.</summary>
sealed class DisturbedSource
{
    readonly DisturbedGateway _gateway;
    readonly Ledger _ledger;
    readonly List<string> _faults;
    readonly Random _random;
    readonly DisturbedMessages _messages;
    readonly List<Channel> _channels = [];
    readonly HashSet<string> _advertised = [];
    readonly string _adapter;
    readonly bool _mayFlood;
    DisturbedClient _client;
    (Channel Channel, string Text, double At) _last;
    double _silentUntil;

    public DisturbedSource(DisturbedGateway gateway, Ledger ledger, List<string> faults, int seed)
    {
        (_gateway, _ledger, _faults, _random) = (gateway, ledger, faults, new Random(seed));
        _messages = new DisturbedMessages(gateway, ledger, _random);
        for (var i = _random.Next(1, 4); i > 0; i--) _channels.Add(_messages.NewChannel());
        // Two adapters may have the same name.
        _adapter = _random.Next(2) == 0 ? null : $"plant/p{_random.Next(3)}";
        _mayFlood = _random.Next(6) == 0;
        Connect();
    }

    public Exception Failure => _client.Failure;

    /// <summary>Does something at random.</summary>
    public void Act()
    {
        if (_gateway.Loop.Seconds < _silentUntil) return;
        if (!_client.IsOpen) Connect();
        var index = _random.Next(_channels.Count);
        var channel = _channels[index];
        switch (_random.Next(60))
        {
            case 0: Connect(); break;
            case 1:
                Close(isClean: _random.Next(2) == 0);
                BeSilent(10);
                break;
            case 2: BeSilent(5); break;
            case 3: Unadvertise(channel); break;
            case 4: Advertise(channel); break;
            case 5: _channels[index] = _messages.WithOtherNames(channel); break;
            case 6: _channels[index] = _messages.NewChannel(); break;
            // After a step of the clock, the stamp of an earlier message may be in the future.
            case 7 when _last.Text != null && _last.At > _gateway.Own.SteppedAt: Publish(_last.Channel, _last.Text); break;
            case 8: Publish(channel, _messages.Of(channel, -_random.NextDouble())); break;
            case 9: Publish(channel, _messages.Of(channel, -20)); break;
            case 10: Publish(channel, _messages.Of(channel, 0.9 * _random.NextDouble())); break;
            case 11 or 12: PublishInvalid(channel); break;
            case 13:
                for (var i = 0; i < 30; i++) Publish(channel);
                break;
            case 14 when _mayFlood: Publish(_messages.NewFlood()); break;
            case 15: _client.Send(_messages.Description()); break;
            case >= 16 and < 20 when _adapter != null: _client.Send(DisturbedMessages.Report(_adapter, _channels)); break;
            default: Publish(channel); break;
        }
    }

    /// <summary>Connects if necessary, and publishes valid messages on all channels.</summary>
    public void Calm()
    {
        if (!_client.IsOpen) Connect();
        foreach (var channel in _channels) Publish(channel);
    }

    public void Close(bool isClean)
    {
        // Before the end, in which the hub publishes values of other sources that it has refused.
        _ledger.Release(_client.Address);
        _client.Close(isClean);
    }

    void Connect()
    {
        if (_client is { IsOpen: true }) Close(_random.Next(2) == 0);
        _client = new DisturbedClient(_gateway, Role.Source, _ => { });
        _advertised.Clear();
        if (_random.Next(2) > 0) return;
        foreach (var channel in _channels) Advertise(channel);
    }

    void BeSilent(double maxSeconds) => _silentUntil = _gateway.Loop.Seconds + maxSeconds * _random.NextDouble();

    void Advertise(Channel channel)
    {
        _client.Send($$"""{"op":"advertise","topic":"{{channel.Topic}}"}""");
        _advertised.Add(channel.Topic);
    }

    void Unadvertise(Channel channel)
    {
        if (_advertised.Remove(channel.Topic)) _ledger.Release(_client.Address, channel.Topic);
        _client.Send($$"""{"op":"unadvertise","topic":"{{channel.Topic}}"}""");
    }

    void PublishInvalid(Channel channel)
    {
        var text = _messages.Of(channel);
        switch (_random.Next(8))
        {
            case 0: PublishInvalid(channel, _messages.Of(channel, ahead: 5)); break;
            case 1: PublishInvalid(channel, text[..^3]); break;
            case 2: PublishInvalid(channel, text.Replace("\"publish\"", "\"republish\"", StringComparison.Ordinal)); break;
            case 3: PublishInvalid(channel, text.Replace(channel.Topic, "/unknown", StringComparison.Ordinal)); break;
            case 4: PublishInvalid(channel, text.Replace("nanosec", "nsec", StringComparison.Ordinal)); break;
            case 5: PublishInvalid(channel, "", _random.Next(2) == 0 ? DropReason.TooLarge : DropReason.TooManyMessages); break;
            case 6: PublishInvalid(channel, _messages.Of(channel, isLastWrong: true), isInPart: true); break;
            default: PublishInvalid(channel, _messages.Of(channel with { Names = [.. channel.Names, channel.Names[0]] }), isInPart: true); break;
        }
    }

    // Checks that an invalid message is counted once, or as often as it has invalid parts and parts of other sources.
    void PublishInvalid(Channel channel, string text, DropReason fault = DropReason.None, bool isInPart = false)
    {
        var (published, drops, reasons) = Send(text, fault);
        if (published.Count > 0 && !(isInPart && channel.HasParts)) Fail("was published although it is invalid");
        if (drops == 0 || (drops > 1 && !isInPart)) Fail($"is invalid and was counted {drops} times");

        void Fail(string why) => Report(channel, why, reasons);
    }

    void Publish(Channel channel) => Publish(channel, _messages.Of(channel));

    // Checks that each part is published, or counted and of another source. The joints of one message are counted together.
    void Publish(Channel channel, string text)
    {
        _last = (channel, text, _gateway.Loop.Seconds);
        var taken = channel.Names.Where(name => _ledger.OwnerOf(channel.Topic, name) is { } owner && owner != _client.Address).ToHashSet();
        var replacements = _ledger.Replacements;
        var (published, drops, reasons) = Send(text, DropReason.None);
        var others = published.Where(one => one.Address != _client.Address || one.Topic != channel.Topic);
        if (_ledger.Replacements == replacements && others.Any()) Fail("published others");
        if (published.Select(one => one.Name).Any(taken.Contains)) Fail("took the names of another source");
        var missing = channel.Names.Except(published.Except(others).Select(one => one.Name)).ToArray();
        var expected = channel.HasParts ? missing.Length : Math.Min(1, missing.Length);
        if (drops != expected) Fail($"lost {missing.Length} parts and was counted {drops} times");
        if (missing.Except(taken).Any() && !IsRule(channel, taken.Count > 0, reasons)) Fail("lost parts that have no other source");

        void Fail(string why) => Report(channel, why, reasons);
    }

    // Whether a rule explains that parts without another source are refused: a tree of frames, a full cell, or all set-points of a message together.
    bool IsRule(Channel channel, bool isTaken, Dictionary<DropReason, long> reasons) => reasons.Keys.Any(reason => reason switch
    {
        DropReason.JointTaken => channel.IsOfPlans && isTaken,
        DropReason.FrameCycle or DropReason.FrameTooDeep => true,
        DropReason.TooManySignals => _ledger.CountOf(channel.Topic) == ProtocolLimits.Signals,
        DropReason.TooManyFrames => _mayFlood || _ledger.CountOf(channel.Topic) > ProtocolLimits.Frames / 2,
        DropReason.TooManyJoints => _ledger.CountOf(channel.Topic) + channel.Names.Length > ProtocolLimits.Joints,
        DropReason.TooManyRobots => _gateway.Hub.Robots.Count == ProtocolLimits.Robots,
        _ => false,
    });

    // Sends a message. Returns what was published, and the number of drops with their reasons.
    (List<Published> Published, long Drops, Dictionary<DropReason, long> Reasons) Send(string text, DropReason fault)
    {
        var (first, before) = (_ledger.All.Count, _gateway.Refused());
        _client.Send(Encoding.UTF8.GetBytes(text), fault);
        _gateway.Loop.Settle();
        var reasons = _gateway.Refused().Where(one => one.Value > before.GetValueOrDefault(one.Key))
            .ToDictionary(one => one.Key, one => one.Value - before.GetValueOrDefault(one.Key));
        return ([.. _ledger.All.Skip(first)], reasons.Values.Sum(), reasons);
    }

    void Report(Channel channel, string why, Dictionary<DropReason, long> reasons)
    {
        var message = $"{_client.Address}: {channel.Topic} {string.Join(',', channel.Names)}";
        _faults.Add($"{_gateway.Loop.Seconds:0.000} s: {message} {why} ({string.Join(", ", reasons)})");
    }
}
