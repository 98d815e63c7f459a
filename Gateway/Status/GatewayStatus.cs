using System.Diagnostics;
using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Status.Cell;
using Nowpose.Gateway.Status.Events;
using Nowpose.Gateway.Status.Joints;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Status;

/// <summary>Monitors the hub and reports the state of the gateway. Thread-safe; does not block publishers.</summary>
sealed class GatewayStatus : IDisposable
{
    // Maximum number of events in the state, which each open page reads twice per second. /operations/events returns all events.
    const int EventsInState = 100;

    static readonly string[] Topics =
    [
        RosTopics.JointStates, RosTopics.JointTrajectory, RosTopics.RobotDescription, RosTopics.Diagnostics, RosTopics.Tf, RosTopics.TfStatic,
        RosTopics.Signals,
    ];

    // Replaces the namespace in the counts of messages, which are summed over all robots with a namespace.
    const string AnyRobot = "/*";
    static readonly string[] Counted = [.. Topics, .. RobotTopic.OfRobots.Select(kind => AnyRobot + kind)];

    readonly GatewayOptions _options;
    readonly ServedClock _clock;
    readonly PlantClocks _plant;
    readonly Recorder _recorder;
    readonly LimitAlarm _limits;
    readonly MessageHub _hub;
    readonly DropCounters _drops;
    readonly (string Name, ConnectionCounters Counters)[] _connections;
    readonly SourceWatch _sources;
    readonly DiagnosticsBoard _diagnostics;
    readonly JointBoard _joints;
    readonly CellBoard _cell;
    readonly RefusalConditions _refusals;
    readonly Conditions _conditions;
    readonly StatusWatch _watch;
    readonly CellReports _cellReports;
    readonly SignalStatusTopic _signals;
    readonly HubSource _version;
    readonly long[] _messages = new long[Counted.Length];
    readonly DateTimeOffset _started;
    readonly long _startCount = Stopwatch.GetTimestamp();

    public GatewayStatus(
        GatewayOptions options, ServedClock clock, PlantClocks plant, MessageHub hub, DropCounters drops, ConnectionCounters sync,
        ConnectionCounters webSocket, Recorder recorder, LimitAlarm limits, EventList events, Action<string> log)
    {
        _options = options;
        _clock = clock;
        _plant = plant;
        _recorder = recorder;
        _limits = limits;
        _hub = hub;
        _drops = drops;
        _connections = [("sync", sync), ("websocket", webSocket)];
        _sources = new SourceWatch(hub.Time);
        _diagnostics = new DiagnosticsBoard(options.Time);
        _joints = new JointBoard(
            options.Time, () => limits.Robots, log,
            () => clock.WrongRate is { } rate ? EventTexts.JointsOfWrongRate(clock.Source, rate) : null);
        _cellReports = new CellReports(options.Time, log);
        _cell = new CellBoard(options.Time, _cellReports, hub.Links.RootOf, hub.Links.JointsOf);
        _refusals = new RefusalConditions(hub, options.Time);
        Events = events;
        _conditions = new Conditions(
            options, clock, _diagnostics, _refusals, new ConnectionLimits(_connections, options.MaxConnections, options.Time),
            _cellReports, _cell, limits, recorder);
        hub.RobotOfListedJoint = _joints.RobotOf;
        hub.Refused += Refuse;
        hub.PartDropped += _cell.Refuse;
        hub.Left += _diagnostics.Remove;
        hub.SampleDropped += _joints.Refuse;
        hub.SourceLeft += Leave;
        hub.SignalsEnded += _cell.End;
        hub.Frames.Ended += _cell.EndFrame;
        hub.Frames.Replaced += _cell.RemoveFrame;
        _started = options.Time.GetUtcNow();
        foreach (var (topic, name) in Topics.Index()) hub.Subscribe(name, message => Watch(topic, message));
        foreach (var (kind, name) in RobotTopic.OfRobots.Index()) hub.SubscribeToRobots(name, message => Watch(Topics.Length + kind, message));
        _version = hub.OpenSource();
        _version.PublishNewest(RosTopics.Version, new StringMessage(Version));
        _signals = new SignalStatusTopic(hub, clock, options.Time.GetUtcNow);
        _watch = new StatusWatch(_conditions, events, _joints, new JointStatusTopic(hub, clock, options.Time), ReportSignals, plant, options.Time, log);
    }

    public static string Version => NowposeVersion.Text;

    public ForwardingTimes Forwarding => _hub.Forwarding;

    public EventList Events { get; }

    /// <summary>Gets the reasons why headsets cannot be served, one line each; empty when the gateway is ready.</summary>
    public IReadOnlyList<string> NotReadyReasons() =>
        [.. ConditionsOf(_joints.Read()).Where(condition => condition.Blocks).Select(condition => condition.TextWithSince)];

    /// <inheritdoc cref="GatewayServer.Expect"/>
    public void Expect(IReadOnlyList<Func<AdapterState>> adapters) => _conditions.Adapters = adapters;

    /// <summary>Ends what publishes. The rest only reads the hub, which has the same lifetime.</summary>
    public void Dispose()
    {
        _watch.Dispose();
        _signals.Dispose();
        _version.Dispose();
    }

    public StatusSnapshot Read()
    {
        var sources = _sources.Read();
        var joints = _joints.Read();
        // Diagnostics do not contain the robot of a headset. With several robots, the age of its samples is therefore unknown.
        var active = sources.SelectMany(source => source.Names).ToHashSet();
        var robots = joints.Where(joint => joint.Robot != null && active.Contains(joint.Name)).Select(joint => joint.Robot).Distinct();
        var hasOneRobot = robots.Count() == 1;
        var forwarding = _hub.Forwarding.SortedRecent();
        var hops = new HopTimes(
            hasOneRobot ? Middle([.. sources.SelectMany(source => source.SortedAges).Order()]) : null, Middle(forwarding));
        var reports = _diagnostics.Read();
        var beyond = _limits.Joints;
        var conditions = ConditionsOf(joints);
        var (frames, signals) = (_cell.Frames(_clock.Now, joints), _cell.Signals(_clock.Now));
        return new StatusSnapshot
        {
            Cell = _options.Cell,
            Host = Environment.MachineName,
            Version = Version,
            Status = OverallStatus.Of(conditions, joints, frames, signals, !_hub.Links.Described.IsEmpty, reports.Count(one => !one.IsOfAdapter)),
            StartedUtc = _started.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture),
            UptimeS = Math.Round(Stopwatch.GetElapsedTime(_startCount).TotalSeconds, 1),
            ControlTimeS = Math.Round(_clock.Now.SinceEpoch.TotalSeconds, 6),
            Clock = OfClock(),
            PlantClocks = [.. _clock.Status().Select(Of)],
            Adapters = [.. reports.Where(one => one.IsOfAdapter).Select(StatusObjects.Adapter)],
            Sources = [.. sources.Select(source => Of(source, beyond))],
            Joints = [.. joints.Select(Of)],
            Frames = frames,
            Signals = signals,
            Headsets = [.. reports.Where(one => !one.IsOfAdapter).Select(one => StatusObjects.Headset(one, hops))],
            ForwardMs = forwarding.Length == 0 ? null : new SpanStatus(At(forwarding, 0.5), At(forwarding, 0.99)),
            Connections = _connections.ToDictionary(server => server.Name, server => Of(server.Counters)),
            Messages = Enumerable.Range(0, Counted.Length).ToDictionary(topic => Counted[topic], topic => Interlocked.Read(ref _messages[topic])),
            Drops = _drops.Snapshot().ToDictionary(drop => drop.Key.ToString(), drop => drop.Value),
            Recording = _recorder.Status,
            PairsHeadsets = _options.Headsets != null,
            IsReady = !conditions.Any(condition => condition.Blocks),
            Events = [.. Events.Read(EventsInState).Select(one => one.View)],
            CertificateExpiresUtc = _options.CertificateExpires,
        };
    }

    IReadOnlyList<Condition> ConditionsOf(IReadOnlyList<JointSnapshot> joints) => Events.Date(_conditions.Read(joints));

    void Watch(int topic, HubMessage message)
    {
        Interlocked.Increment(ref _messages[topic]);
        if (message.Content is JointStateMessage state)
        {
            var age = _clock.AtReceived(message.ReceivedAt) - state.Stamp;
            _sources.Add(message.Joints, message.ReceivedAt, age);
            _joints.Add(message.Source, message.Joints, state.Stamp, age, message.Robot);
        }
        else if (message.Kind is RosTopics.JointTrajectory or RosTopics.RobotDescription) _refusals.Accept(message);
        else if (message.Content is TransformsMessage frames)
            _cell.Add(message.Source, frames, message.Topic == RosTopics.TfStatic, _clock.AtReceived(message.ReceivedAt));
        else if (message.Content is SignalsMessage signals) _cell.Add(message.Source, signals);
        else if (message.Content is DiagnosticsMessage diagnostics)
        {
            _diagnostics.Add(diagnostics);
            if (StatusObjects.IsAdapter(diagnostics.HardwareId)) Report(message.Source, diagnostics);
        }
    }

    void Report(HubSource source, DiagnosticsMessage diagnostics)
    {
        var name = StatusObjects.AdapterName(diagnostics.HardwareId);
        if (source != null) source.Name = name;
        _joints.Report(name, diagnostics.Values, source, diagnostics.Stamp);
        _cellReports.Add(name, diagnostics.Values, source, diagnostics.Stamp);
        ReportSignals();
    }

    // Under the hub's lock, so that no older list replaces a newer one.
    void ReportSignals() => _hub.Exclusively(() => _signals.Report(_cell.FaultySignals(_clock.Now), _options.Time.GetUtcNow()));

    void Refuse(HubSource source, string topic, string name, HubSource owner)
    {
        if (topic == RosTopics.JointStates) _joints.Refuse(source, name, owner);
    }

    void Leave(HubSource source, string topic)
    {
        if (topic == null) _joints.Leave(source);
        else if (RobotTopic.Parse(topic) is { Kind: RosTopics.JointStates } ended) _joints.Leave(source, ended.Robot);
        _cell.Leave(source, topic);
    }

    static JointView Of(JointSnapshot joint) => new(
        joint.Name, joint.Source, joint.Word, UtcText.Of(joint.Since), joint.Age is { } age ? Math.Round(age.TotalSeconds, 3) : null, joint.RateHz,
        joint.Reason, joint.Uncertainty.Length == 0 ? null : joint.Uncertainty, joint.ReasonWord, joint.Robot);

    ClockStatus OfClock()
    {
        var control = _plant.Control;
        // Reads the model once, because bound and estimated error grow with the time since the newest exchange.
        var model = control?.Model;
        var known = model is { IsKnown: true } ? model : null;
        var isKnown = _clock.State != ClockState.Unsynchronised;
        return new ClockStatus(
            _clock.Source, _clock.State.Word(), _clock.IsSynchronised, isKnown ? Rounded((known?.ErrorBound ?? _clock.ErrorBound).TotalMicroseconds) : null,
            isKnown ? Rounded(_clock.Skew * 1e6) : null, Measured(control?.RoundTripTime)?.TotalMilliseconds,
            Measured(control == null ? _clock.Resolution : control.Resolution)?.TotalMicroseconds, model?.Steps,
            known?.EstimatedError is { } error ? Rounded(error.TotalMicroseconds) : null,
            _clock.Stamps.Warning);
    }

    static PlantClockView Of(PlantClockStatus clock) => new(
        clock.Name, clock.IsConnected, clock.IsControlClock, clock.State.Word(),
        clock.OffsetToControl is { } ahead ? Rounded(ahead.TotalMilliseconds) : null, clock.SkewPpm is { } skew ? Rounded(skew) : null,
        Measured(clock.RoundTripTime)?.TotalMilliseconds,
        clock.State == ClockState.Unsynchronised ? null : Rounded(clock.ErrorBound.TotalMicroseconds),
        Measured(clock.Resolution)?.TotalMicroseconds, clock.Exchanges, clock.Failures, clock.LastFailure,
        clock.EstimatedError is { } error ? Rounded(error.TotalMicroseconds) : null);

    // Returns null for zero, which means that the value has not been measured yet.
    static TimeSpan? Measured(TimeSpan? length) => length > TimeSpan.Zero ? length : null;

    static double Rounded(double value) => Math.Round(value, 3);

    static SourceStatus Of((string[] Names, double RateHz, TimeSpan[] SortedAges) source, IReadOnlyList<string> beyond) => new(
        source.Names, Math.Round(source.RateHz, 2),
        source.SortedAges.Length == 0 ? null : new AgeStatus(At(source.SortedAges, 0.5), At(source.SortedAges, 0.95)),
        [.. source.Names.Intersect(beyond)]);

    static ConnectionStatus Of(ConnectionCounters counters) => new(
        counters.Open, counters.Accepted,
        Enum.GetValues<Closure>().Where(why => counters[why] > 0).ToDictionary(why => why.ToString(), why => counters[why]));

    static double? Middle(TimeSpan[] sorted) => sorted.Length == 0 ? null : At(sorted, 0.5);

    static double At(TimeSpan[] sorted, double fraction) =>
        Math.Round(sorted[(int)Math.Ceiling(fraction * (sorted.Length - 1))].TotalMilliseconds, 3);
}
