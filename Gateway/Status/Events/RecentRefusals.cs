using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Joints, frames and signals that were recently refused because another source publishes them. Thread-safe; bounded.</summary>
sealed class RecentRefusals(TimeProvider time)
{
    const int MaxRefusals = 64;

    /// <summary>Time for which a joint, frame or signal of a source counts as refused after its last refused message.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<(string Source, string Kind, string Name), (long At, string Owner)> _refusals = [];

    /// <param name="kind">One of <see cref="CellKinds"/>.</param>
    public void Add(HubSource source, string kind, string name, HubSource owner)
    {
        lock (_lock)
        {
            // Keyed by title, so that a client that reconnects counts as the same source.
            var key = (source.Title, kind, name);
            if (_refusals.Count < MaxRefusals || _refusals.ContainsKey(key)) _refusals[key] = (time.GetTimestamp(), owner.Title);
        }
    }

    public IReadOnlyList<(string Source, string Kind, string Name, string Owner)> Read()
    {
        lock (_lock)
        {
            foreach (var (key, refusal) in _refusals)
                if (time.GetElapsedTime(refusal.At) > Span) _refusals.Remove(key);
            return [.. _refusals.Select(one => (one.Key.Source, one.Key.Kind, one.Key.Name, one.Value.Owner))];
        }
    }
}
