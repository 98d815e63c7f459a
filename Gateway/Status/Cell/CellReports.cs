using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Cell;

/// <summary>An adapter's report about a frame or a signal.</summary>
sealed record CellReport(string Name, string Adapter, AdapterReport Report);

/// <summary>The adapters' newest reports about their frames and signals. Thread-safe.</summary>
/// <remarks>Reports expire, because a silent adapter is reported as a separate fault, and its frames and signals end with its connection.</remarks>
sealed class CellReports(TimeProvider time)
{
    /// <summary>Maximum number of adapters. The limit bounds the memory that a faulty client can use by sending many names.</summary>
    internal const int MaxAdapters = 16;

    readonly Lock _lock = new();
    readonly Dictionary<string, (long At, IReadOnlyList<KeyValuePair<string, AdapterReport>> Reports)> _adapters = [];

    /// <summary>Stores the diagnostics of an adapter, which have a key for each configured frame and signal.</summary>
    public void Add(string adapter, IReadOnlyCollection<KeyValuePair<string, string>> values)
    {
        var reports = Read(values, AdapterReport.FramePrefix, ProtocolLimits.Frames).Concat(Read(values, AdapterReport.SignalPrefix, ProtocolLimits.Signals)).ToList();
        lock (_lock)
        {
            foreach (var (name, one) in _adapters)
                if (!IsValid(one.At)) _adapters.Remove(name);
            if (_adapters.ContainsKey(adapter) || _adapters.Count < MaxAdapters) _adapters[adapter] = (time.GetTimestamp(), reports);
        }
    }

    /// <summary>Gets the reports about frames or signals that are neither live nor at rest.</summary>
    /// <param name="kind"><see cref="AdapterReport.FramePrefix"/> or <see cref="AdapterReport.SignalPrefix"/>.</param>
    public IReadOnlyList<CellReport> Troubled(string kind)
    {
        lock (_lock)
            return
            [
                .. from adapter in _adapters
                   where IsValid(adapter.Value.At)
                   from one in adapter.Value.Reports
                   where one.Key.StartsWith(kind, StringComparison.Ordinal) && !one.Value.State.IsGood()
                   select new CellReport(one.Key[kind.Length..], adapter.Key, one.Value),
            ];
    }

    /// <summary>Gets an adapter's report that a frame or signal is at rest; null if there is none.</summary>
    /// <param name="key"><see cref="AdapterReport.FramePrefix"/> or <see cref="AdapterReport.SignalPrefix"/>, and the name.</param>
    public AdapterReport? RestOf(string key, string adapter)
    {
        lock (_lock)
        {
            if (!_adapters.TryGetValue(adapter, out var known) || !IsValid(known.At)) return null;
            foreach (var one in known.Reports)
                if (one.Key == key && one.Value.State == JointDataState.Rest) return one.Value;
            return null;
        }
    }

    bool IsValid(long at) => time.GetElapsedTime(at) < AdapterReport.Validity;

    static IEnumerable<KeyValuePair<string, AdapterReport>> Read(IEnumerable<KeyValuePair<string, string>> values, string kind, int limit) =>
        values.Where(pair => pair.Key.StartsWith(kind, StringComparison.Ordinal))
            .SelectMany(pair => AdapterReport.TryParse(pair.Value, out var report) ? [KeyValuePair.Create(pair.Key, report)] : Array.Empty<KeyValuePair<string, AdapterReport>>())
            .DistinctBy(pair => pair.Key).Take(limit);
}
