using System.Globalization;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Keeps the newest events, and logs the start and end of each event. Thread-safe.</summary>
/// <param name="log">Receives each line and its kind, which has a rate limit of its own.</param>
sealed class EventList(TimeProvider time, Action<string, string> log)
{
    /// <summary>Maximum number of events, except while more are active.</summary>
    internal const int MaxEvents = 500;

    /// <summary>Time after the start of the gateway or of a client in which conditions that are normal at startup cause no event.</summary>
    internal static readonly TimeSpan StartGrace = TimeSpan.FromSeconds(3);

    readonly long _started = time.GetTimestamp();
    // Start of each condition that has no event yet because of StartGrace.
    readonly Dictionary<(string, string, string), (DateTimeOffset Since, long Timestamp)> _pending = [];
    readonly Lock _lock = new();
    // In the order of their start, the oldest first.
    readonly List<StatusEvent> _events = [];
    long _lastId;

    /// <summary>Starts an event for each new condition, and ends the event of each condition that is over.</summary>
    public void Update(IReadOnlyCollection<Condition> present)
    {
        List<(string Text, Condition Condition)> lines = [];
        lock (_lock)
        {
            var now = time.GetUtcNow();
            var byKey = present.DistinctBy(condition => condition.Key).ToDictionary(condition => condition.Key);
            for (var i = 0; i < _events.Count; i++)
            {
                var known = _events[i];
                if (known.Until != null) continue;
                if (byKey.Remove(known.Condition.Key, out var condition)) _events[i] = known with { Condition = condition };
                else lines.Add((EndLine(_events[i] = known with { Until = now }), known.Condition));
            }

            foreach (var key in _pending.Keys.Where(key => !byKey.ContainsKey(key)).ToList()) _pending.Remove(key);
            foreach (var condition in byKey.Values)
            {
                if (condition.IsNormalAtStart && (condition.Age ?? time.GetElapsedTime(_started)) < StartGrace)
                    _pending.TryAdd(condition.Key, StartOf(condition));
                else lines.Add((Begin(condition, _pending.Remove(condition.Key, out var start) ? start : StartOf(condition), null), condition));
            }
        }

        foreach (var (text, condition) in lines) Log(text, condition);
    }

    /// <summary>Adds an event without a duration.</summary>
    public void Note(Condition condition)
    {
        string line;
        lock (_lock)
        {
            var now = time.GetUtcNow();
            line = Begin(condition, (now, time.GetTimestamp()), now);
        }

        Log(line, condition);
    }

    /// <summary>Gets the newest events and all active events, the newest first.</summary>
    /// <param name="newest">Maximum number of newest events. Older events that are still active are added.</param>
    public IReadOnlyList<StatusEvent> Read(int newest = MaxEvents)
    {
        lock (_lock) return [.. Enumerable.Reverse(_events).Where((one, i) => i < newest || one.Until == null)];
    }

    /// <summary>Sets the start of each current condition from its event. A condition without an event and without a start starts now.</summary>
    public IReadOnlyList<Condition> Date(IReadOnlyList<Condition> present)
    {
        lock (_lock)
        {
            var now = time.GetUtcNow();
            var begins = _events.Where(known => known.Until == null).ToDictionary(known => known.Condition.Key, known => known.Since);
            foreach (var (key, start) in _pending) begins.TryAdd(key, start.Since);
            return [.. present.Select(one => one with { Since = begins.TryGetValue(one.Key, out var since) ? since : one.Since ?? now })];
        }
    }

    // The start on both clocks: the system clock may be set while the condition lasts, so the duration is measured by timestamps.
    (DateTimeOffset Since, long Timestamp) StartOf(Condition condition)
    {
        var now = time.GetUtcNow();
        var since = condition.Since ?? now;
        return (since, time.GetTimestamp() - (long)(Math.Max(0, (now - since).TotalSeconds) * time.TimestampFrequency));
    }

    string Begin(Condition condition, (DateTimeOffset Since, long Timestamp) start, DateTimeOffset? until)
    {
        // Removes only events that are over. An active event that were removed would begin again at the next update. The number of active events is
        // limited by the number of joints, frames, signals and clients.
        while (_events.Count >= MaxEvents && OldestOfTheMostFrequentKind() is { } over) _events.Remove(over);
        _events.Add(new StatusEvent(++_lastId, condition, start.Since, until) { Began = start.Timestamp });
        return $"event {_lastId}: {condition.Text}";
    }

    // Events of a kind that a client causes in any number, such as headsets with new names, must not replace those of other kinds.
    StatusEvent OldestOfTheMostFrequentKind() =>
        _events.Where(known => known.Until != null).GroupBy(known => known.Condition.Kind).MaxBy(kind => kind.Count())?.First();

    void Log(string line, Condition condition) => log(line, EventTexts.OtherEvents(condition.Kind));

    string EndLine(StatusEvent ended) => string.Create(
        CultureInfo.InvariantCulture,
        $"event {ended.Id}: ended after {time.GetElapsedTime(ended.Began).TotalSeconds:0.0} s: {ended.Condition.Headline}");
}
