using System.Diagnostics;
using System.Globalization;
using System.Reflection;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Recording;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>Watches what passes the hub, and says how the gateway does. Any thread; who publishes waits for nobody.</summary>
sealed class GatewayStatus : IDisposable
{
    static readonly string[] Topics = [RosTopics.JointStates, RosTopics.JointTrajectory, RosTopics.RobotDescription, RosTopics.Diagnostics];

    readonly GatewayOptions _options;
    readonly ServedClock _clock;
    readonly PlantClocks _plant;
    readonly Recorder _recorder;
    readonly LimitAlarm _limits;
    readonly MessageHub _hub;
    readonly DropCounters _drops;
    readonly (string Name, ConnectionCounters Counters)[] _connections;
    readonly SourceWatch _sources = new();
    readonly DiagnosticsBoard _said;
    readonly long[] _messages = new long[Topics.Length];
    readonly DateTimeOffset _started;
    readonly long _startCount = Stopwatch.GetTimestamp();
    readonly IDisposable[] _subscriptions;

    public GatewayStatus(
        GatewayOptions options, ServedClock clock, PlantClocks plant, MessageHub hub, DropCounters drops, ConnectionCounters sync,
        ConnectionCounters webSocket, Recorder recorder, LimitAlarm limits)
    {
        _options = options;
        _clock = clock;
        _plant = plant;
        _recorder = recorder;
        _limits = limits;
        _hub = hub;
        _drops = drops;
        _connections = [("sync", sync), ("websocket", webSocket)];
        _said = new DiagnosticsBoard(options.Time);
        _started = options.Time.GetUtcNow();
        _subscriptions = [.. Enumerable.Range(0, Topics.Length).Select(topic => hub.Subscribe(Topics[topic], message => Watch(topic, message)))];
    }

    public static string Version { get; } = typeof(GatewayStatus).Assembly.GetName().Version.ToString(3);

    public ForwardingTimes Forwarding => _hub.Forwarding;

    /// <summary>Whether C1 may be trusted, and joint positions come where they should; cheap, whoever asks.</summary>
    public bool IsReady => _clock.IsSynchronised && (!_options.ExpectsSources || _sources.HasAny);

    public void Dispose()
    {
        foreach (var subscription in _subscriptions) subscription.Dispose();
    }

    public StatusSnapshot Read()
    {
        var sources = _sources.Read();
        var hops = new HopTimes(
            Middle([.. sources.SelectMany(source => source.SortedAges).Order()]), _hub.Forwarding.Percentile(0.5)?.TotalMilliseconds);
        var said = _said.Read();
        var beyond = _limits.Joints;
        return new StatusSnapshot(
            _options.Cell, Version, _started.UtcDateTime.ToString("yyyy-MM-dd'T'HH:mm:ss'Z'", CultureInfo.InvariantCulture),
            Math.Round(Stopwatch.GetElapsedTime(_startCount).TotalSeconds, 1), Math.Round(_clock.Now.SinceEpoch.TotalSeconds, 6), OfClock(),
            [.. _clock.Status().Select(Of)],
            [.. said.Where(IsAdapter).Select(StatusObjects.Adapter)],
            [.. sources.Select(source => Of(source, beyond))],
            [.. said.Where(one => !IsAdapter(one)).Select(one => StatusObjects.Headset(one, hops))],
            OfForwarding(),
            _connections.ToDictionary(server => server.Name, server => Of(server.Counters)),
            Enumerable.Range(0, Topics.Length).ToDictionary(topic => Topics[topic], topic => Interlocked.Read(ref _messages[topic])),
            _drops.Snapshot().ToDictionary(drop => drop.Key.ToString(), drop => drop.Value),
            _recorder.Status, _options.Headsets != null, IsReady, CertificateExpiresUtc: _options.CertificateExpires);
    }

    void Watch(int topic, HubMessage message)
    {
        Interlocked.Increment(ref _messages[topic]);
        if (message.Content is JointStateMessage state)
            _sources.Add(state.Names, message.ReceivedAt, _clock.Now - Stopwatch.GetElapsedTime(message.ReceivedAt) - state.Stamp);
        else if (message.Content is DiagnosticsMessage diagnostics)
            _said.Add(diagnostics);
    }

    ClockStatus OfClock()
    {
        var control = _plant.Control;
        var isKnown = _clock.State != ClockState.Unsynchronised;
        return new ClockStatus(
            _clock.Source, _clock.State.Word(), _clock.IsSynchronised, isKnown ? Rounded(_clock.ErrorBound.TotalMicroseconds) : null,
            isKnown ? Rounded(_clock.Skew * 1e6) : null, Measured(control?.RoundTripTime)?.TotalMilliseconds,
            Measured(control == null ? _clock.Resolution : control.Resolution)?.TotalMicroseconds, control?.Model.Steps);
    }

    static PlantClockView Of(PlantClockStatus clock) => new(
        clock.Name, clock.IsConnected, clock.IsControlClock, clock.State.Word(),
        clock.OffsetToControl is { } ahead ? Rounded(ahead.TotalMilliseconds) : null, clock.DriftPpm is { } drift ? Rounded(drift) : null,
        Measured(clock.RoundTripTime)?.TotalMilliseconds,
        clock.State == ClockState.Unsynchronised ? null : Rounded(clock.ErrorBound.TotalMicroseconds),
        Measured(clock.Resolution)?.TotalMicroseconds, clock.Exchanges, clock.Failures, clock.LastFailure);

    // Zero is what it is before the first.
    static TimeSpan? Measured(TimeSpan? length) => length > TimeSpan.Zero ? length : null;

    static double Rounded(double value) => Math.Round(value, 3);

    SpanStatus OfForwarding() => _hub.Forwarding.Percentile(0.5) is { } half && _hub.Forwarding.Percentile(0.99) is { } most
        ? new SpanStatus(Math.Round(half.TotalMilliseconds, 3), Math.Round(most.TotalMilliseconds, 3)) : null;

    static SourceStatus Of((string[] Names, double RateHz, TimeSpan[] SortedAges) source, IReadOnlyList<string> beyond) => new(
        source.Names, Math.Round(source.RateHz, 2),
        source.SortedAges.Length == 0 ? null : new AgeStatus(At(source.SortedAges, 0.5), At(source.SortedAges, 0.95)),
        [.. source.Names.Intersect(beyond)]);

    static ConnectionStatus Of(ConnectionCounters counters) => new(
        counters.Open, counters.Accepted,
        Enum.GetValues<Closure>().Where(why => counters[why] > 0).ToDictionary(why => why.ToString(), why => counters[why]));

    static bool IsAdapter((string Name, TimeSpan, IReadOnlyList<KeyValuePair<string, string>>) one) =>
        one.Name.StartsWith(StatusObjects.AdapterPrefix, StringComparison.Ordinal);

    static double? Middle(TimeSpan[] sorted) => sorted.Length == 0 ? null : At(sorted, 0.5);

    static double At(TimeSpan[] sorted, double fraction) =>
        Math.Round(sorted[(int)Math.Ceiling(fraction * (sorted.Length - 1))].TotalMilliseconds, 3);
}
