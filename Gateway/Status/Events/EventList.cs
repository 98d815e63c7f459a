using System.Globalization;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Keeps the newest events with their start and end, and logs both. Thread-safe.</summary>
sealed class EventList(TimeProvider time, Action<string> log)
{
    internal const int MaxEvents = 500;

    /// <summary>Time after the start in which conditions that are normal at the start cause no event.</summary>
    internal static readonly TimeSpan StartGrace = TimeSpan.FromSeconds(3);

    readonly long _started = time.GetTimestamp();
    // Conditions that have no event yet because of this time, with their start.
    readonly Dictionary<(string, string, string), DateTimeOffset> _pending = [];
    readonly Lock _lock = new();
    // The oldest first.
    readonly List<StatusEvent> _events = [];
    long _lastId;

    /// <summary>Starts the events of new conditions and ends those of conditions that are over.</summary>
    public void Update(IReadOnlyCollection<Condition> present)
    {
        List<string> lines = [];
        lock (_lock)
        {
            var now = time.GetUtcNow();
            var byKey = present.DistinctBy(condition => condition.Key).ToDictionary(condition => condition.Key);
            for (var i = 0; i < _events.Count; i++)
            {
                var known = _events[i];
                if (known.Until != null) continue;
                if (byKey.Remove(known.Condition.Key, out var condition)) _events[i] = known with { Condition = condition };
                else lines.Add(EndLine(_events[i] = known with { Until = now }));
            }

            foreach (var key in _pending.Keys.Where(key => !byKey.ContainsKey(key)).ToList()) _pending.Remove(key);
            foreach (var condition in byKey.Values)
            {
                if (condition.IsNormalAtStart && time.GetElapsedTime(_started) < StartGrace) _pending.TryAdd(condition.Key, condition.Since ?? now);
                else lines.Add(Begin(condition, _pending.Remove(condition.Key, out var since) ? since : condition.Since ?? now, null));
            }
        }

        lines.ForEach(log);
    }

    /// <summary>Adds an instantaneous event.</summary>
    public void Note(Condition condition)
    {
        string line;
        lock (_lock)
        {
            var now = time.GetUtcNow();
            line = Begin(condition, now, now);
        }

        log(line);
    }

    /// <summary>Gets the newest events and all active ones, the newest first.</summary>
    public IReadOnlyList<StatusEvent> Read(int newest = MaxEvents)
    {
        lock (_lock) return [.. Enumerable.Reverse(_events).Where((one, i) => i < newest || one.Until == null)];
    }

    /// <summary>Adds the start of their events to the current conditions. A condition without an event starts now.</summary>
    public IReadOnlyList<Condition> Date(IReadOnlyList<Condition> present)
    {
        lock (_lock)
        {
            var now = time.GetUtcNow();
            var begins = _events.Where(known => known.Until == null).ToDictionary(known => known.Condition.Key, known => known.Since);
            foreach (var (key, since) in _pending) begins.TryAdd(key, since);
            return [.. present.Select(one => one with { Since = begins.TryGetValue(one.Key, out var since) ? since : one.Since ?? now })];
        }
    }

    string Begin(Condition condition, DateTimeOffset since, DateTimeOffset? until)
    {
        // An active event is more important than an older one that is over.
        if (_events.Count >= MaxEvents) _events.RemoveAt(Math.Max(0, _events.FindIndex(known => known.Until != null)));
        _events.Add(new StatusEvent(++_lastId, condition, since, until));
        return $"event {_lastId}: {condition.Text}";
    }

    static string EndLine(StatusEvent ended) => string.Create(
        CultureInfo.InvariantCulture,
        $"event {ended.Id}: over after {(ended.Until.Value - ended.Since).TotalSeconds:0.0} s: {ended.Condition.Headline}");
}
