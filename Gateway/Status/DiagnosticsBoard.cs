using Nowpose.Gateway.Status.Joints;

namespace Nowpose.Gateway.Status;

/// <summary>The latest diagnostics of each headset and adapter. Thread-safe; the number of names is limited.</summary>
sealed class DiagnosticsBoard(TimeProvider time)
{
    /// <summary>Maximum number of names. Only a client that invents names can exceed it.</summary>
    internal const int MaxClients = 512;

    internal const int MaxValues = 256;

    /// <summary>
    /// Maximum length of a value in characters, equal to the maximum length of an adapter's log line. The reason for a refused certificate needs
    /// half of it.
    /// </summary>
    internal const int MaxValueLength = 1000;

    /// <summary>Maximum number of characters of all names and values together.</summary>
    internal const int MaxLength = 16 * 1024;

    /// <summary>
    /// Time after which a silent headset is removed. A silent adapter is not removed: it is a fault until the gateway is restarted.
    /// </summary>
    internal static readonly TimeSpan ForgottenAfter = TimeSpan.FromSeconds(30);

    readonly Lock _lock = new();
    // First: arrival of the first report since the client was added.
    readonly Dictionary<string, (long First, long At, KeyValuePair<string, string>[] Values)> _reports = [];

    public void Add(DiagnosticsMessage message)
    {
        var values = Kept(message.Values);
        lock (_lock)
        {
            if (_reports.Count >= MaxClients && !_reports.ContainsKey(message.HardwareId)) MakeRoom();
            var now = time.GetTimestamp();
            _reports[message.HardwareId] = (_reports.TryGetValue(message.HardwareId, out var before) ? before.First : now, now, values);
        }
    }

    /// <summary>Removes a headset that has disconnected normally. Does not remove an adapter, whose absence is a fault.</summary>
    public void Remove(string name)
    {
        if (StatusObjects.IsAdapter(name)) return;
        lock (_lock) _reports.Remove(name);
    }

    /// <summary>Gets the diagnostics in the order of their names.</summary>
    public IReadOnlyList<ClientReport> Read()
    {
        lock (_lock)
        {
            foreach (var (name, report) in _reports)
                if (!StatusObjects.IsAdapter(name) && time.GetElapsedTime(report.At) > ForgottenAfter) _reports.Remove(name);
            return
            [
                .. _reports.OrderBy(report => report.Key, StringComparer.Ordinal).Select(report => new ClientReport(
                    report.Key, time.GetElapsedTime(report.Value.At), time.GetElapsedTime(report.Value.First), report.Value.Values)),
            ];
        }
    }

    // Returns a compact copy, because messages of up to 64 KiB would use too much memory for hundreds of names.
    static KeyValuePair<string, string>[] Kept(IEnumerable<KeyValuePair<string, string>> values)
    {
        var room = MaxLength;
        return
        [
            .. values.Where(pair => !AdapterReport.IsKey(pair.Key)).Take(MaxValues).Select(pair => KeyValuePair.Create(pair.Key, InputException.OneLine(pair.Value, MaxValueLength)))
                .TakeWhile(pair => (room -= pair.Key.Length + pair.Value.Length) >= 0),
        ];
    }

    // Removes the headset that has been silent for the longest time; without a headset, the adapter that has been silent for the longest time.
    void MakeRoom() => _reports.Remove(_reports.OrderBy(report => StatusObjects.IsAdapter(report.Key)).ThenBy(report => report.Value.At).First().Key);
}

/// <summary>The latest diagnostics of a headset or an adapter.</summary>
/// <param name="Name">Its hardware_id.</param>
/// <param name="Ago">Time since the report.</param>
/// <param name="Age">Time since its first report.</param>
sealed record ClientReport(string Name, TimeSpan Ago, TimeSpan Age, IReadOnlyList<KeyValuePair<string, string>> Values)
{
    public bool IsOfAdapter => StatusObjects.IsAdapter(Name);
}
