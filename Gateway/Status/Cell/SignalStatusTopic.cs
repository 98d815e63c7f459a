using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>
/// Publishes the list of signals without current values on /nowpose/signal_status after each change of the list. These are the signals whose
/// source has ended, those that an adapter reports with a fault, those of an adapter that has stopped reporting, and those whose newest value the gateway has refused.
/// </summary>
/// <remarks>
/// Headsets need the list, because a signal that is published only on change may be silent for hours and still be current. All methods run
/// under the hub's lock.
/// </remarks>
sealed class SignalStatusTopic : IDisposable
{
    const int MaxReasonLength = 64;

    /// <summary>
    /// Maximum length of all names and reasons together, in bytes. The rest of the maximum message length is for the JSON around them.
    /// </summary>
    const int MaxBytes = 48 * 1024;

    readonly MessageHub _hub;
    readonly IControlClock _clock;
    readonly Func<DateTimeOffset> _utcNow;
    readonly HubSource _source;
    // Signals whose source has ended, in the order in which the sources ended.
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
        // Publishes an empty list for headsets that still show the list of an earlier run. Its stamp is zero, because the clock may be unknown.
        Publish(default, default);
    }

    public void Dispose()
    {
        _hub.SignalsEnded -= End;
        _hub.SignalsBegan -= Begin;
        _source.Dispose();
    }

    /// <summary>Updates the signals that adapters report with a fault, and those that the gateway refuses.</summary>
    public void Report(IReadOnlyList<CellReport> reports, DateTimeOffset utcNow) => _hub.Exclusively(() =>
    {
        // An adapter may still report during a shutdown. The hub would keep a list that is published then.
        if (_source.IsEnded || reports.Select(Key).SequenceEqual(_reported.Select(Key))) return;
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
        // If the list is too long, the reported signals have priority, and then the signals that ended last.
        var bytes = 0;
        var reported = _reported.Select(one => new Row(
            one.Name, one.Report.State, now - (utcNow - one.Report.Since), InputException.OneLine(one.Report.Reason, MaxReasonLength)));
        var rows = reported.Concat(_ended.AsEnumerable().Reverse()).DistinctBy(one => one.Signal).Take(ProtocolLimits.Signals)
            .TakeWhile(one => (bytes += RosMessageWriter.MaxBytesOf(one.Signal) + RosMessageWriter.MaxBytesOf(one.Reason)) <= MaxBytes);
        var values = rows.Select(one => KeyValuePair.Create(one.Signal, string.Create(
            CultureInfo.InvariantCulture, $"{JointDataStates.Of(one.State)} {one.Since.SinceEpoch.TotalSeconds:0.000} {one.Reason}"))).ToList();
        _source.PublishNewest(RosTopics.SignalStatus, new DiagnosticsMessage(now, "gateway", values, values.Count == 0 ? 0 : 2, "signals"));
    }

    static (string, JointDataState, DateTimeOffset, string) Key(CellReport one) => (one.Name, one.Report.State, one.Report.Since, one.Report.Reason);

    readonly record struct Row(string Signal, JointDataState State, ControlTime Since, string Reason);
}
