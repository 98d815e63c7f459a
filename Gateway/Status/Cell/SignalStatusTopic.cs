using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>Publishes the signals that are not current on /nowpose/signal_status, on each change: their source has ended, or its adapter reports why.</summary>
/// <remarks>
/// A signal that is published on change is silent for hours, so a headset cannot see from its silence that its value is no longer current.
/// Works under the hub's lock, one call at a time.
/// </remarks>
sealed class SignalStatusTopic : IDisposable
{
    const int MaxReasonLength = 64;

    /// <summary>Maximum length of all names and reasons, which leaves room for the JSON around them within the maximum of a message.</summary>
    const int MaxBytes = 48 * 1024;

    readonly MessageHub _hub;
    readonly IControlClock _clock;
    readonly Func<DateTimeOffset> _utcNow;
    readonly HubSource _source;
    // In the order in which they ended.
    readonly List<Row> _ended = [];
    IReadOnlyList<CellReport> _reported = [];

    /// <param name="utcNow">Wall clock of this machine.</param>
    public SignalStatusTopic(MessageHub hub, IControlClock clock, Func<DateTimeOffset> utcNow)
    {
        _utcNow = utcNow;
        _hub = hub;
        _clock = clock;
        _source = hub.OpenSource();
        hub.SignalsEnded += End;
        hub.SignalsBegan += Begin;
        // For headsets that still show the state of an earlier run. The clock may not be available yet.
        Publish(default, default);
    }

    public void Dispose()
    {
        _hub.SignalsEnded -= End;
        _hub.SignalsBegan -= Begin;
        _source.Dispose();
    }

    /// <summary>Takes the signals that adapters report as not current.</summary>
    public void Report(IReadOnlyList<CellReport> reports, DateTimeOffset utcNow) => _hub.Exclusively(() =>
    {
        if (reports.Select(Key).SequenceEqual(_reported.Select(Key))) return;
        _reported = reports;
        Publish(_clock.Now, utcNow);
    });

    void Begin(IReadOnlyCollection<string> signals)
    {
        if (_ended.RemoveAll(one => signals.Contains(one.Signal)) > 0) Publish(_clock.Now, _utcNow());
    }

    void End(HubSource source, IReadOnlyCollection<string> signals)
    {
        var now = _clock.Now;
        var reason = InputException.OneLine(EventTexts.SourceEnded(source.Title), MaxReasonLength);
        _ended.RemoveAll(one => signals.Contains(one.Signal));
        _ended.AddRange(signals.Select(signal => new Row(signal, JointDataState.Stale, now, reason)));
        if (_ended.Count > ProtocolLimits.Signals) _ended.RemoveRange(0, _ended.Count - ProtocolLimits.Signals);
        Publish(now, _utcNow());
    }

    void Publish(ControlTime now, DateTimeOffset utcNow)
    {
        // Those that ended last have priority.
        var bytes = 0;
        var reported = _reported.Select(one => new Row(
            one.Name, one.Report.State, now - (utcNow - one.Report.Since), InputException.OneLine(one.Report.Reason, MaxReasonLength)));
        var rows = _ended.AsEnumerable().Reverse().Concat(reported).DistinctBy(one => one.Signal)
            .TakeWhile(one => (bytes += MessageParts.BytesOf(one.Signal) + MessageParts.BytesOf(one.Reason)) <= MaxBytes);
        var values = rows.Select(one => KeyValuePair.Create(one.Signal, string.Create(
            CultureInfo.InvariantCulture, $"{JointDataStates.Of(one.State)} {one.Since.SinceEpoch.TotalSeconds:0.000} {one.Reason}"))).ToList();
        _source.PublishSignalStatus(new DiagnosticsMessage(now, "gateway", values, values.Count == 0 ? 0 : 2, "signals"));
    }

    static (string, JointDataState, DateTimeOffset, string) Key(CellReport one) => (one.Name, one.Report.State, one.Report.Since, one.Report.Reason);

    readonly record struct Row(string Signal, JointDataState State, ControlTime Since, string Reason);
}
