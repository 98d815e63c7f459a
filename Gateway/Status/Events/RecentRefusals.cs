using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Sources whose samples were recently refused because another source publishes one of their joints. Thread-safe; bounded.</summary>
sealed class RecentRefusals(TimeProvider time)
{
    const int MaxRefusals = 64;

    /// <summary>Time for which a source counts as refused after its last refused sample.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<(string Source, string Joint), (long At, string Owner)> _refusals = [];

    public void Add(HubSource source, string joint, HubSource owner)
    {
        lock (_lock)
        {
            // Keyed by title, so that a client that reconnects counts as the same source.
            var key = (source.Title, joint);
            if (_refusals.Count < MaxRefusals || _refusals.ContainsKey(key)) _refusals[key] = (time.GetTimestamp(), owner.Title);
        }
    }

    public IReadOnlyList<(string Source, string Joint, string Owner)> Read()
    {
        lock (_lock)
        {
            foreach (var (key, refusal) in _refusals)
                if (time.GetElapsedTime(refusal.At) > Span) _refusals.Remove(key);
            return [.. _refusals.Select(one => (one.Key.Source, one.Key.Joint, one.Value.Owner))];
        }
    }
}
