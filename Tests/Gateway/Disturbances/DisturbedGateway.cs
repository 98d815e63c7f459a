using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Recording;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status;
using Nowpose.Gateway.Status.Events;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway.Disturbances;

/// <summary>The parts of a gateway without its sockets, in virtual time.</summary>
sealed class DisturbedGateway
{
    readonly NamesInUse _names;
    readonly List<MemoryStream> _files = [];
    int _connections;

    public DisturbedGateway()
    {
        var options = new GatewayOptions { Time = Loop.Time, SystemClock = Loop.Time, Recordings = "recordings" };
        Plant = new PlantClocks(null, Loop);
        Own = new DisturbedControlClock(Loop);
        Clock = new ServedClock(Own, Plant, Loop.Time);
        Hub = new MessageHub(Loop.Time);
        _names = new NamesInUse(Loop.Time);
        Recorder = new Recorder(options, Hub, Clock, Plant, Drops, Log, _ => Open());
        var limits = new LimitAlarm(Hub, Log);
        var events = new EventList(Loop.Time, (line, _) => Log(line));
        Status = new GatewayStatus(
            options, Clock, Plant, Hub, Drops, new ConnectionCounters(), new ConnectionCounters(), Recorder, limits, events, Log);
        Comparison = new ClockComparison(Clock, Log);
    }

    public VirtualLoop Loop { get; } = new();
    public MessageHub Hub { get; }
    public PlantClocks Plant { get; }
    public ServedClock Clock { get; }
    public DisturbedControlClock Own { get; }
    public DropCounters Drops { get; } = new();
    public Recorder Recorder { get; }
    public GatewayStatus Status { get; }
    public ClockComparison Comparison { get; }

    /// <summary>Lines of the log.</summary>
    public List<string> Logged { get; } = [];

    /// <summary>Number of drops for each reason except a slow reader.</summary>
    public Dictionary<DropReason, long> Refused() => Drops.Snapshot().Where(one => one.Key != DropReason.SlowReader).ToDictionary();

    public RosbridgeSession Connect(Role role, string address, Action<ReadOnlyMemory<byte>> reply, Action<Subscription> start) =>
        new(Hub, Clock, Plant, _names, role, Drops, 16, reply, start) { Address = address, MaxMessagesPerSecond = 1000 };

    public string NextAddress() => $"10.0.0.{++_connections}";

    /// <summary>Ends all parts, and gets the recorded lines.</summary>
    public IReadOnlyCollection<string> End()
    {
        Recorder.SwitchOffAsync().Wait();
        Status.Dispose();
        Comparison.Dispose();
        Recorder.DisposeAsync().AsTask().Wait();
        return [.. _files.SelectMany(file => Encoding.UTF8.GetString(file.ToArray()).Split('\n', StringSplitOptions.RemoveEmptyEntries))];
    }

    LineFile Open()
    {
        var file = new MemoryStream();
        lock (_files) _files.Add(file);
        return new LineFile(file);
    }

    void Log(string line)
    {
        lock (Logged) Logged.Add(line);
    }
}

/// <summary>A control clock that can be set.</summary>
sealed class DisturbedControlClock(VirtualLoop loop) : IControlClock
{
    static readonly TimeSpan Start = TimeSpan.FromDays(20_000);

    TimeSpan _correction;

    /// <summary>Time at which the clock was last set, s.</summary>
    public double SteppedAt { get; private set; } = double.MinValue;

    public ControlTime Now => new(Start + TimeSpan.FromSeconds(loop.Seconds) + _correction);

    public void Set(TimeSpan by)
    {
        _correction += by;
        SteppedAt = loop.Seconds;
    }
}
