using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Joints, frames and signals that are refused because another source publishes them. Thread-safe; bounded.</summary>
/// <remarks>
/// A refusal on a topic with regular messages ends soon after the last refused message. Stationary frames and signals are sent only once, so their refusals
/// last until the source ends or no other source owns the name.
/// </remarks>
sealed class RecentRefusals(TimeProvider time)
{
    const int MaxRefusals = 64;

    /// <summary>Minimum time for which a joint, frame or signal of a source counts as refused after its last refused message.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<(string Source, string Kind, string Name), Refused> _refusals = [];

    /// <summary>Adds a refusal, or repeats it. Called under the hub's lock.</summary>
    public void Add(HubSource source, string topic, string name, HubSource owner)
    {
        lock (_lock)
        {
            // Keyed by title, so that a client that reconnects counts as the same source.
            var key = (source.Title, CellKinds.Of(topic), name);
            if (_refusals.Count < MaxRefusals || _refusals.ContainsKey(key))
                _refusals[key] = new Refused(source, owner.Title, time.GetTimestamp(), MessageHub.IsLatched(topic));
        }
    }

    public IReadOnlyList<(string Source, string Kind, string Name, string Owner)> Read()
    {
        KeyValuePair<(string Source, string Kind, string Name), Refused>[] known;
        lock (_lock) known = [.. _refusals];
        // Not under the lock, because this uses the hub's lock.
        var over = known.Where(one => IsOver(one.Key.Kind, one.Key.Name, one.Value)).ToList();
        lock (_lock)
        {
            foreach (var (key, refused) in over)
                if (_refusals.GetValueOrDefault(key) == refused) _refusals.Remove(key);
            return [.. _refusals.Select(one => (one.Key.Source, one.Key.Kind, one.Key.Name, one.Value.Owner))];
        }
    }

    bool IsOver(string kind, string name, Refused refused) => time.GetElapsedTime(refused.At) > Span
        && (!refused.IsLatched || refused.Source.IsEnded || refused.Source.MayPublishPart(kind, name));

    sealed record Refused(HubSource Source, string Owner, long At, bool IsLatched);
}
