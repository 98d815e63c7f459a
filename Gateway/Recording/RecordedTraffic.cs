using System.Diagnostics;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol.Cell;
using Nowpose.Recording;
using Nowpose.Session;
using Nowpose.Sync;

namespace Nowpose.Gateway.Recording;

/// <summary>Converts the gateway's traffic to records of a session file. C2 in these records is this machine's counter.</summary>
/// <remarks>Thread-safe; does not block publishers.</remarks>
sealed class RecordedTraffic(ServedClock clock, PlantClocks plant, DropCounters drops)
{
    readonly IPerformanceCounterClock _counter = plant.Counter;
    (string Source, int Steps)? _timeLine;
    long _recordedDrops;

    public void Add(RecordedFile file, HubMessage message)
    {
        switch (message.Content)
        {
            case JointStateMessage state: AddSample(file, message, state); break;
            case JointTrajectoryMessage plan: AddPlan(file, message, plan); break;
            case TransformsMessage poses: AddPoses(file, message, poses); break;
            case SignalsMessage signals: AddSignals(file, message, signals); break;
            case DiagnosticsMessage diagnostics: AddDiagnostics(file, message, diagnostics); break;
        }
    }

    public void Add(RecordedFile file, PlantClock asked, in SyncExchange exchange, SyncVerdict verdict, SyncExchangeFault fault)
    {
        // Records only exchanges with C1.
        if (asked != plant.Control || file.TryClaim(RecordKind.Sync) is not { } record) return;
        record.SetExchange(exchange, verdict, fault);
        file.Publish(record);
    }

    /// <summary>Adds the periodic records. Called once a second, by one thread at a time.</summary>
    public void Tick(RecordedFile file)
    {
        AddTimeLine(file);
        if (plant.Control == null) AddOwnClock(file);
        AddDrops(file);
    }

    /// <summary>Prepares for a new file, so that the next <see cref="Tick"/> repeats the description of C1 and the drop counts.</summary>
    public void Begin()
    {
        _timeLine = null;
        _recordedDrops = 0;
    }

    void AddSample(RecordedFile file, HubMessage message, JointStateMessage state)
    {
        var arrival = clock.AtReceived(message.ReceivedAt);
        if (file.TryClaim(RecordKind.Sample) is not { } record) return;
        record.SetSample(new Arrival<JointStateMessage>(state, _counter.At(message.ReceivedAt)), arrival, PrefixOf(message), DropReason.None);
        file.Publish(record);
    }

    void AddPlan(RecordedFile file, HubMessage message, JointTrajectoryMessage plan)
    {
        if (file.TryClaim(RecordKind.Plan) is not { } record) return;
        record.SetPlan(new Arrival<JointTrajectoryMessage>(plan, _counter.At(message.ReceivedAt)), PrefixOf(message), DropReason.None);
        file.Publish(record);
    }

    void AddPoses(RecordedFile file, HubMessage message, TransformsMessage poses)
    {
        var (at, arrival) = (_counter.At(message.ReceivedAt), clock.AtReceived(message.ReceivedAt));
        for (var i = 0; i < poses.Count; i++)
        {
            if (file.TryClaim(RecordKind.Pose) is not { } record) return;
            record.SetPose(poses[i], message.Topic == RosTopics.TfStatic, at, arrival, DropReason.None);
            file.Publish(record);
        }
    }

    void AddSignals(RecordedFile file, HubMessage message, SignalsMessage signals)
    {
        var (at, arrival) = (_counter.At(message.ReceivedAt), clock.AtReceived(message.ReceivedAt));
        for (var i = 0; i < signals.Count; i++)
        {
            if (file.TryClaim(RecordKind.Signal) is not { } record) return;
            record.SetSignal(signals[i], signals.Stamp, at, arrival, DropReason.None);
            file.Publish(record);
        }
    }

    // Null for the robot without a namespace, because its joints are named as in the file's header.
    static string PrefixOf(HubMessage message) => message.Robot.Length == 0 ? null : message.Robot + "/";

    void AddDiagnostics(RecordedFile file, HubMessage message, DiagnosticsMessage diagnostics)
    {
        if (file.TryClaim(RecordKind.Diagnostics) is not { } record) return;
        record.At = _counter.At(message.ReceivedAt);
        record.Diagnostics = diagnostics;
        file.Publish(record);
    }

    // Marks the places where the time line of C1 changes, because another clock became C1 or the clock was set. Stamps before and after such a
    // place are not comparable.
    void AddTimeLine(RecordedFile file)
    {
        var now = (clock.Source, plant.Control?.Model.Steps ?? 0);
        if (now == _timeLine || file.TryClaim(RecordKind.Clock) is not { } record) return;
        record.SetClock(_counter.Now, plant.Control?.Model ?? default, isNewStart: _timeLine != null);
        _timeLine = now;
        file.Publish(record);
    }

    // The gateway's own clock is read without exchanges. Its offset is recorded as an exchange, so that readers of the file find an offset.
    void AddOwnClock(RecordedFile file)
    {
        var before = _counter.Now;
        var now = clock.Now;
        var exchange = new SyncExchange(before, now, now, _counter.Now, clock.Resolution, clock.ErrorBound, clock.IsSynchronised);
        if (file.TryClaim(RecordKind.Sync) is not { } record) return;
        record.SetExchange(exchange, SyncVerdict.Consistent, SyncExchangeFault.None);
        file.Publish(record);
    }

    void AddDrops(RecordedFile file)
    {
        var total = drops.Total;
        if (total == _recordedDrops || file.TryClaim(RecordKind.Drops) is not { } record) return;
        _recordedDrops = total;
        record.At = _counter.Now;
        DropsLine.Fill(drops, record.Numbers);
        file.Publish(record);
    }
}
