using Nowpose.Gateway.Hub;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Signals;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>One joint, frame or signal of a published message.</summary>
/// <param name="Order">Position in the order of publication.</param>
/// <param name="At">Time of the publication, s.</param>
/// <param name="Age">Control time of the publication minus the stamp.</param>
sealed record Published(
    long Order, string Topic, string Name, double Value, ControlTime Stamp, string Parent, HubSource Source, double At, TimeSpan Age)
{
    public static readonly TimeSpan MaxAge = TimeSpan.FromSeconds(10);

    public string Address => Source.Address;
    public bool IsOld => Age > MaxAge;
}

/// <summary>All that the hub publishes, with the owners of all names. Checks that each name has one owner at a time.</summary>
sealed class Ledger : IDisposable
{
    /// <summary>Time without a new stamp after which a joint is stale, s.</summary>
    public const double JointSilence = 1.8;

    static readonly string[] Topics =
    [
        RosTopics.JointStates, RosTopics.JointTrajectory, RosTopics.RobotDescription, RosTopics.Tf, RosTopics.TfStatic, RosTopics.Signals,
        RosTopics.Diagnostics,
    ];

    readonly DisturbedGateway _gateway;
    readonly List<string> _faults;
    // The hub also publishes on the thread that has parsed a description.
    readonly Lock _lock = new();
    readonly List<IDisposable> _subscriptions = [];
    readonly Dictionary<(string Kind, string Name), (string Address, string Topic)> _owners = [];
    readonly Dictionary<string, Published> _signals = [];
    int _values;

    public Ledger(DisturbedGateway gateway, List<string> faults)
    {
        (_gateway, _faults) = (gateway, faults);
        foreach (var topic in Topics) _subscriptions.Add(gateway.Hub.Subscribe(topic, Add));
        foreach (var kind in RobotTopic.OfRobots) _subscriptions.Add(gateway.Hub.SubscribeToRobots(kind, Add));
        _subscriptions.Add(gateway.Hub.Subscribe(RosTopics.SignalStatus, message => SignalStatus = (DiagnosticsMessage)message.Content));
        _subscriptions.Add(gateway.Hub.Subscribe(RosTopics.JointStatus, message => JointStatus = (DiagnosticsMessage)message.Content));
        gateway.Hub.Frames.Ended += name => Remove(name, isForgotten: Newest.GetValueOrDefault((RosTopics.Tf, name))?.Topic == RosTopics.TfStatic);
        gateway.Hub.Frames.Replaced += name =>
        {
            Replacements++;
            Remove(name, isForgotten: true);
        };
    }

    public List<Published> All { get; } = [];

    /// <summary>Number of messages by topic, with those of all namespaces together.</summary>
    public Dictionary<string, long> Messages { get; } = [];

    /// <summary>Number of frames that other frames have replaced.</summary>
    public int Replacements { get; private set; }

    public DiagnosticsMessage SignalStatus { get; private set; }
    public DiagnosticsMessage JointStatus { get; private set; }

    /// <summary>Newest publication of each joint, frame and signal, also after the end of its source.</summary>
    public Dictionary<(string Kind, string Name), Published> Newest { get; } = [];

    /// <summary>Orders of the publications of each value.</summary>
    public Dictionary<(string Topic, string Name, double Value), List<long>> Orders { get; } = [];

    /// <summary>Time of the newest publication with another stamp or source, s.</summary>
    public Dictionary<(string Kind, string Name), double> Changed { get; } = [];

    /// <summary>Time since which the samples of a joint have had no pause, s.</summary>
    public Dictionary<(string Kind, string Name), double> LiveSince { get; } = [];

    /// <summary>Returns the topic for which names are unique: frames on /tf and /tf_static have the same names.</summary>
    public static string KindOf(string topic) => topic == RosTopics.TfStatic ? RosTopics.Tf : topic;

    public string OwnerOf(string topic, string name) => _owners.GetValueOrDefault((KindOf(topic), name)).Address;

    public int CountOf(string topic) => _owners.Keys.Count(key => key.Kind == KindOf(topic));

    /// <summary>Returns a value that no message had before.</summary>
    public int NextValue() => ++_values;

    /// <summary>Gets the newest value of a signal by its time stamp.</summary>
    public Published NewestSignal(string name) => _signals[name];

    /// <summary>Releases the names of a source.</summary>
    /// <param name="topic">The topic that it unadvertises; null for all.</param>
    public void Release(string address, string topic = null)
    {
        foreach (var (name, owner) in _owners)
            if (owner.Address == address && (topic == null || owner.Topic == topic)) _owners.Remove(name);
    }

    public void Dispose()
    {
        foreach (var one in _subscriptions) one.Dispose();
    }

    void Remove(string frame, bool isForgotten)
    {
        lock (_lock)
        {
            _owners.Remove((RosTopics.Tf, frame));
            if (isForgotten) Newest.Remove((RosTopics.Tf, frame));
        }
    }

    void Add(HubMessage message)
    {
        lock (_lock) AddParts(message);
    }

    void AddParts(HubMessage message)
    {
        var counted = message.Robot.Length > 0 ? "/*" + message.Kind : message.Topic;
        Messages[counted] = Messages.GetValueOrDefault(counted) + 1;
        switch (message.Content)
        {
            case JointStateMessage state:
                for (var i = 0; i < state.Names.Length; i++) Add(message, state.Names[i], state.Positions[i], state.Stamp);
                break;
            case JointTrajectoryMessage plan:
                foreach (var name in plan.Names) Add(message, name, plan.Points[0].Positions[0], plan.Stamp);
                break;
            case TransformsMessage poses:
                for (var i = 0; i < poses.Count; i++) Add(message, poses[i].Child, poses[i].X, poses[i].Stamp, poses[i].Parent);
                break;
            case SignalsMessage signals:
                for (var i = 0; i < signals.Count; i++) Add(message, signals[i].Name, signals[i].Value, signals.Stamp);
                break;
        }
    }

    void Add(HubMessage message, string name, double value, ControlTime stamp, string parent = null)
    {
        var now = _gateway.Loop.Seconds;
        var one = new Published(All.Count, message.Topic, name, value, stamp, parent, message.Source, now, _gateway.Clock.Now - stamp);
        var key = (KindOf(message.Topic), name);
        var isOwned = _owners.TryGetValue(key, out var owner);
        if (isOwned && owner.Address != one.Address)
            _faults.Add($"{now:0.000} s: {message.Topic} {name} of {owner.Address} was published by {one.Address}");
        if (message.Source.IsEnded) _faults.Add($"{now:0.000} s: {message.Topic} {name} was published by {one.Address}, which has ended");
        if (one.Topic == RosTopics.Signals && IsNewest(one, isOwned)) _signals[name] = one;
        Track(key, one);
        _owners[key] = (one.Address, one.Topic);
        Newest[key] = one;
        All.Add(one);
        if (!Orders.TryGetValue((one.Topic, name, value), out var orders)) Orders[(one.Topic, name, value)] = orders = [];
        orders.Add(one.Order);
    }

    bool IsNewest(Published one, bool isOwned) => !isOwned || !_signals.TryGetValue(one.Name, out var before) || before.Source != one.Source
        || !LateValues.IsOvertaken(one.Stamp, before.Stamp);

    void Track((string Kind, string Name) key, Published one)
    {
        var before = Newest.GetValueOrDefault(key);
        if (before != null && before.Stamp == one.Stamp && before.Source == one.Source && before.Topic == one.Topic) return;
        if (before == null || before.IsOld || one.At - Changed[key] >= JointSilence) LiveSince[key] = one.At;
        Changed[key] = one.At;
    }
}
