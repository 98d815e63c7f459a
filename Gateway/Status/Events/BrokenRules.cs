using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>
/// Clients that break a rule for all their messages, because they send more than their role allows, or may not publish. Thread-safe; bounded.
/// </summary>
sealed class BrokenRules(TimeProvider time)
{
    /// <summary>Maximum number of clients with the rules that they break.</summary>
    const int MaxEntries = 64;

    /// <summary>Time for which a client counts as breaking a rule after its last dropped message.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<(string Client, string What), (string Rule, long At)> _entries = [];

    /// <summary>Adds a dropped message of a client.</summary>
    /// <param name="what">What the client does, as a predicate.</param>
    /// <param name="rule">The rule that the client breaks, with the remedy.</param>
    public void Add(HubSource client, string what, string rule)
    {
        var key = (client.Title, what);
        lock (_lock)
            if (_entries.Count < MaxEntries || _entries.ContainsKey(key)) _entries[key] = (rule, time.GetTimestamp());
    }

    /// <summary>Gets the titles of the clients, each with what it does and the rule that it breaks.</summary>
    public IReadOnlyList<(string Client, string What, string Rule)> Read()
    {
        lock (_lock)
        {
            foreach (var (key, dropped) in _entries)
                if (time.GetElapsedTime(dropped.At) > Span) _entries.Remove(key);
            return [.. _entries.Select(one => (one.Key.Client, one.Key.What, one.Value.Rule))];
        }
    }
}
