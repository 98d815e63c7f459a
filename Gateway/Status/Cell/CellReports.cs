using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>An adapter's report about a frame or a signal.</summary>
sealed record CellReport(string Name, string Adapter, AdapterReport Report);

/// <summary>The adapters' newest reports about their frames and signals. Thread-safe.</summary>
/// <remarks>
/// A report about a fault is valid until the adapter's next report or the end of its connection, which also ends the adapter's frames and signals. A
/// report that a value is current expires, because nothing confirms the value while the adapter is silent.
/// </remarks>
/// <param name="log">Called once, when there are too many adapters; null for no log.</param>
sealed class CellReports(TimeProvider time, Action<string> log = null)
{
    /// <summary>
    /// Maximum number of adapters with frames or signals. The limit bounds the memory that a faulty client can use by sending many names.
    /// </summary>
    internal const int MaxAdapters = 64;

    readonly Lock _lock = new();
    readonly Dictionary<string, Received> _adapters = [];
    bool _isLimitLogged;

    /// <summary>Stores the diagnostics of an adapter, which have a key for each configured frame and signal.</summary>
    /// <param name="source">The adapter's connection; null if unknown.</param>
    /// <param name="sent">Stamp of the diagnostics; zero if unknown.</param>
    public void Add(string adapter, IReadOnlyCollection<KeyValuePair<string, string>> values, HubSource source = null, ControlTime sent = default)
    {
        var now = time.GetUtcNow();
        var reports = new Dictionary<string, AdapterReport>();
        foreach (var (kind, limit) in new[] { (AdapterReport.FramePrefix, ProtocolLimits.Frames), (AdapterReport.SignalPrefix, ProtocolLimits.Signals) })
        {
            var most = reports.Count + limit;
            foreach (var (key, value) in values.Where(pair => pair.Key.StartsWith(kind, StringComparison.Ordinal)))
                if (reports.Count < most && AdapterReport.TryParse(value, sent, now, out var report)) reports.TryAdd(key, report);
        }

        lock (_lock)
        {
            foreach (var (name, one) in _adapters)
                if (!one.IsConnected) _adapters.Remove(name);
            _adapters.Remove(adapter, out var previous);
            if (reports.Count == 0) return;
            if (_adapters.Count < MaxAdapters)
            {
                var kept = reports.ToDictionary(one => one.Key, one => one.Value.After(previous?.Reports.GetValueOrDefault(one.Key) ?? default));
                _adapters[adapter] = new Received(source, time.GetTimestamp(), now, kept);
                return;
            }

            if (_isLimitLogged) return;
            _isLimitLogged = true;
        }

        log?.Invoke(AdapterMessages.TooMany(adapter, MaxAdapters));
    }

    /// <summary>Gets the reports about frames or signals that are neither live nor at rest.</summary>
    /// <param name="kind"><see cref="AdapterReport.FramePrefix"/> or <see cref="AdapterReport.SignalPrefix"/>.</param>
    public IReadOnlyList<CellReport> Troubled(string kind) => Select(kind, (_, report) => report.State.IsGood() ? null : report);

    /// <summary>Gets the reports about frames or signals that are at rest.</summary>
    /// <inheritdoc cref="Troubled" path="/param"/>
    public IReadOnlyList<CellReport> AtRest(string kind) => Select(kind, (_, report) => report.State == JointDataState.Rest ? report : null);

    /// <summary>Gets the frames or signals that were live or at rest in the newest report of an adapter that has stopped reporting.</summary>
    /// <inheritdoc cref="Troubled" path="/param"/>
    public IReadOnlyList<CellReport> Unconfirmed(string kind) => Select(
        kind, (adapter, report) => report.State.IsGood() && !IsFresh(adapter)
            ? new AdapterReport(JointDataState.Stale, adapter.Utc, CellReasons.AdapterSilent) : null);

    /// <summary>Gets an adapter's report that a frame or signal is at rest; null if there is none.</summary>
    /// <param name="key"><see cref="AdapterReport.FramePrefix"/> or <see cref="AdapterReport.SignalPrefix"/>, and the name.</param>
    public AdapterReport? RestOf(string key, string adapter)
    {
        lock (_lock)
        {
            if (!_adapters.TryGetValue(adapter, out var known) || !known.IsConnected || !IsFresh(known)) return null;
            return known.Reports.TryGetValue(key, out var report) && report.State == JointDataState.Rest ? report : null;
        }
    }

    bool IsFresh(Received adapter) => time.GetElapsedTime(adapter.At) < AdapterReport.Validity;

    IReadOnlyList<CellReport> Select(string kind, Func<Received, AdapterReport, AdapterReport?> of)
    {
        lock (_lock)
            return
            [
                .. from adapter in _adapters
                   where adapter.Value.IsConnected
                   from one in adapter.Value.Reports
                   where one.Key.StartsWith(kind, StringComparison.Ordinal)
                   let report = of(adapter.Value, one.Value)
                   where report != null
                   select new CellReport(one.Key[kind.Length..], adapter.Key, report.Value),
            ];
    }

    /// <param name="At">Arrival, a timestamp of the time provider.</param>
    sealed record Received(HubSource Source, long At, DateTimeOffset Utc, Dictionary<string, AdapterReport> Reports)
    {
        public bool IsConnected => Source is not { IsEnded: true };
    }
}
