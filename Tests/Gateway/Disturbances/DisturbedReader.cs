using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>
/// A headset or page that subscribes, reads slowly at times and reconnects. Checks that it receives each name in the order of publication, and each
/// value once.
/// </summary>
sealed class DisturbedReader
{
    static readonly string[] Topics =
    [
        RosTopics.JointStates, "/r1/joint_states", RosTopics.Tf, RosTopics.TfStatic, RosTopics.Signals, RosTopics.JointTrajectory,
        "/r1/joint_trajectory",
    ];

    readonly DisturbedGateway _gateway;
    readonly Ledger _ledger;
    readonly List<string> _faults;
    readonly Random _random;
    readonly Dictionary<string, Subscribed> _topics = [];
    DisturbedClient _client;
    bool _hasBeenSlow;

    public DisturbedReader(DisturbedGateway gateway, Ledger ledger, List<string> faults, int seed)
    {
        (_gateway, _ledger, _faults, _random) = (gateway, ledger, faults, new Random(seed));
        Connect();
    }

    public Exception Failure => _client.Failure;

    /// <summary>Does something at random.</summary>
    public void Act()
    {
        switch (_random.Next(10))
        {
            case 0: Read(0); break;
            case 1: Read(SlowRate()); break;
            case 2 or 3: Read(double.PositiveInfinity); break;
            case 4: Connect(); break;
            case 5: Unsubscribe(Topics[_random.Next(Topics.Length)]); break;
            default: Subscribe(Topics[_random.Next(Topics.Length)]); break;
        }
    }

    public void Close(bool isClean) => _client.Close(isClean);

    public void Calm() => Read(double.PositiveInfinity);

    /// <summary>Checks that the newest value of each name has arrived. Call this method while nothing is sent.</summary>
    public void CheckNewest()
    {
        foreach (var ((kind, name), newest) in _ledger.Newest)
        {
            // If set-points of one joint wait too long, those of another one may replace them.
            if (!_topics.TryGetValue(newest.Topic, out var own) || kind.EndsWith(RosTopics.JointTrajectory, StringComparison.Ordinal)) continue;
            if (newest.Topic != RosTopics.TfStatic && _ledger.OwnerOf(newest.Topic, name) != newest.Address) continue;
            var wanted = newest.Topic == RosTopics.Signals ? _ledger.NewestSignal(name) : newest;
            if (newest.Topic == RosTopics.Tf && wanted.Order < own.Since) continue;
            // A duplicate has the value of an earlier message.
            var first = _ledger.Orders[(newest.Topic, name, wanted.Value)][0];
            if (own.Last.GetValueOrDefault(name, -1) < first) Fail(newest.Topic, $"{name} {wanted.Value} is missing");
        }
    }

    /// <summary>Checks that a client that has always kept up has received everything. Call this method while nothing is sent.</summary>
    public void CheckComplete()
    {
        if (_hasBeenSlow) return;
        foreach (var (topic, own) in _topics.Where(one => !one.Value.IsLimited))
            foreach (var one in _ledger.All.Skip((int)own.Since).Where(one => one.Topic == topic && !own.Orders.Contains(one.Order)))
                if (_ledger.Orders[(topic, one.Name, one.Value)].Count == 1) Fail(topic, $"{one.Name} {one.Value} was lost");
    }

    double SlowRate() => Math.Pow(10, 2.5 + 2 * _random.NextDouble());

    void Read(double bytesPerSecond)
    {
        _hasBeenSlow |= bytesPerSecond < double.PositiveInfinity;
        _client.Read(bytesPerSecond);
    }

    void Connect()
    {
        _client?.Close(_random.Next(2) == 0);
        _topics.Clear();
        _client = new DisturbedClient(_gateway, Role.Observer, Receive);
        _hasBeenSlow = false;
        if (_random.Next(3) == 0) Read(SlowRate());
        foreach (var topic in Topics)
            if (_random.Next(3) > 0) Subscribe(topic);
    }

    void Subscribe(string topic)
    {
        var throttle = _random.Next(3) == 0 ? _random.Next(1, 800) : 0;
        var queue = _random.Next(3) == 0 ? _random.Next(1, throttle > 0 ? 5 : 64) : 0;
        var last = _topics.GetValueOrDefault(topic)?.Last ?? [];
        _topics[topic] = new Subscribed(last, _ledger.All.Count, IsLimited: throttle > 0 || queue > 0);
        _client.Send($$"""{"op":"subscribe","topic":"{{topic}}","id":"a","throttle_rate":{{throttle}},"queue_length":{{queue}}}""");
    }

    void Unsubscribe(string topic)
    {
        _topics.Remove(topic);
        _client.Send($$"""{"op":"unsubscribe","topic":"{{topic}}"}""");
    }

    void Receive(string text)
    {
        if (!RosbridgeReader.TryRead(text, out var message, out var reason)) Fail(text, $"cannot be read: {reason}");
        // A message may be under way at the end of its subscription.
        else if (_topics.TryGetValue(message.Topic, out var own))
            foreach (var (name, value) in PartsOf(message)) Receive(message.Topic, own, name, value);
    }

    void Receive(string topic, Subscribed own, string name, double value)
    {
        if (!_ledger.Orders.TryGetValue((topic, name, value), out var orders))
        {
            Fail(topic, $"{name} {value} was never published");
            return;
        }

        var last = own.Last.GetValueOrDefault(name, -1);
        if (orders[^1] > last) own.Orders.Add(own.Last[name] = orders.Find(one => one > last));
        else if (!own.MayRepeat(name)) Fail(topic, $"{name} {value} arrived again, or after a newer one");
    }

    void Fail(string what, string why) => _faults.Add($"{_gateway.Loop.Seconds:0.000} s: {_client.Address}: {what}: {why}");

    static IEnumerable<(string Name, double Value)> PartsOf(RosbridgeMessage message)
    {
        if (message.JointState is { } state) return state.Names.Zip(state.Positions);
        if (message.JointTrajectory is { } plan) return plan.Names.Select(name => (name, plan.Points[0].Positions[0]));
        if (message.Signals is { } signals) return Enumerable.Range(0, signals.Count).Select(i => (signals[i].Name, signals[i].Value));
        return Enumerable.Range(0, message.Transforms.Count).Select(i => (message.Transforms[i].Child, message.Transforms[i].X));
    }

    /// <param name="Last">Order of the newest received value of each name.</param>
    /// <param name="Since">Order of the first publication after the subscription.</param>
    /// <param name="IsLimited">Whether the client wants fewer messages, or a shorter queue.</param>
    sealed record Subscribed(Dictionary<string, long> Last, long Since, bool IsLimited)
    {
        readonly Dictionary<string, int> _repeats = [];

        /// <summary>Orders of all received values.</summary>
        public HashSet<long> Orders { get; } = [];

        // A new subscription repeats kept values, and so may the message of the subscription before that is under way.
        public bool MayRepeat(string name) => (_repeats[name] = _repeats.GetValueOrDefault(name) + 1) <= 2;
    }
}
