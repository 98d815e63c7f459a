using System.Globalization;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>Publishes the signals whose source has ended on /nowpose/signal_status, on each change.</summary>
/// <remarks>
/// A signal that is published on change is silent for hours, so a headset cannot see from its silence that its value is no longer current.
/// The hub calls this class under its lock, one call at a time.
/// </remarks>
sealed class SignalStatusTopic : IDisposable
{
    const int MaxReasonLength = 64;

    /// <summary>Maximum length of all names and reasons, which leaves room for the JSON around them within the maximum of a message.</summary>
    const int MaxBytes = 48 * 1024;

    readonly MessageHub _hub;
    readonly IControlClock _clock;
    readonly HubSource _source;
    // In the order in which they ended.
    readonly List<(string Signal, ControlTime Since, string Reason)> _ended = [];

    public SignalStatusTopic(MessageHub hub, IControlClock clock)
    {
        _hub = hub;
        _clock = clock;
        _source = hub.OpenSource();
        hub.SignalsEnded += End;
        hub.SignalsBegan += Begin;
        // For headsets that still show the state of an earlier run. The clock may not be available yet.
        Publish(default);
    }

    public void Dispose()
    {
        _hub.SignalsEnded -= End;
        _hub.SignalsBegan -= Begin;
        _source.Dispose();
    }

    void Begin(IReadOnlyCollection<string> signals)
    {
        if (_ended.RemoveAll(one => signals.Contains(one.Signal)) > 0) Publish(_clock.Now);
    }

    void End(HubSource source, IReadOnlyCollection<string> signals)
    {
        var now = _clock.Now;
        var reason = InputException.OneLine($"its source {source.Title} has ended", MaxReasonLength);
        _ended.RemoveAll(one => signals.Contains(one.Signal));
        _ended.AddRange(signals.Select(signal => (signal, now, reason)));
        if (_ended.Count > ProtocolLimits.Signals) _ended.RemoveRange(0, _ended.Count - ProtocolLimits.Signals);
        Publish(now);
    }

    void Publish(ControlTime now)
    {
        // Those that ended last have priority.
        var bytes = 0;
        var rows = _ended.AsEnumerable().Reverse().TakeWhile(one => (bytes += MessageParts.BytesOf(one.Signal) + MessageParts.BytesOf(one.Reason)) <= MaxBytes);
        var values = rows.Select(one => KeyValuePair.Create(one.Signal, string.Create(
            CultureInfo.InvariantCulture, $"{JointDataStates.Of(JointDataState.Stale)} {one.Since.SinceEpoch.TotalSeconds:0.000} {one.Reason}"))).ToList();
        _source.PublishSignalStatus(new DiagnosticsMessage(now, "gateway", values, values.Count == 0 ? 0 : 2, "signals"));
    }
}
