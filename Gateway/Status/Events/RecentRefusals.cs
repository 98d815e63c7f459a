using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Joints, frames and signals that are refused because another source publishes them. Thread-safe; bounded.</summary>
/// <remarks>
/// A refusal on a topic with regular messages ends soon after the last refused message. Stationary frames and signals are sent only once, so their refusals
/// last until the source ends or unadvertises the topic, or no other source owns the name.
/// </remarks>
sealed class RecentRefusals(TimeProvider time)
{
    /// <summary>Maximum number of refusals, in total and of one source.</summary>
    const int MaxRefusals = 64, MaxOfSource = 16;

    /// <summary>Minimum time for which a joint, frame or signal of a source counts as refused after its last refused message.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    /// <summary>Time for which a repeated refusal is ignored, because a source may repeat it with each message.</summary>
    static readonly TimeSpan Repetition = TimeSpan.FromSeconds(1);

    readonly Lock _lock = new();
    readonly Dictionary<(HubSource Source, string Topic, string Name), (long At, HubSource Owner)> _refusals = [];

    /// <summary>Adds a refusal, or repeats it. Called under the hub's lock.</summary>
    public void Add(HubSource source, string topic, string name, HubSource owner)
    {
        lock (_lock)
        {
            var key = (source, topic, name);
            if (_refusals.TryGetValue(key, out var last) && last.Owner == owner && time.GetElapsedTime(last.At) < Repetition) return;
            // A client that reconnects is another source. Its earlier refusal is then not needed.
            foreach (var known in _refusals.Keys.Where(known => known.Source.IsEnded && known.Topic == topic && known.Name == name).ToList())
                if (known.Source.Title == source.Title) _refusals.Remove(known);
            if (_refusals.ContainsKey(key) || (_refusals.Count < MaxRefusals && _refusals.Keys.Count(known => known.Source == source) < MaxOfSource))
                _refusals[key] = (time.GetTimestamp(), owner);
        }
    }

    /// <summary>Removes the refusals of a source on a topic that it no longer publishes. Called under the hub's lock.</summary>
    public void Remove(HubSource source, string topic)
    {
        lock (_lock)
            foreach (var key in _refusals.Keys.Where(key => key.Source == source && key.Topic == topic).ToList()) _refusals.Remove(key);
    }

    /// <summary>Gets each refusal once, with the titles of the refused source and of the source that owns the name.</summary>
    public IReadOnlyList<(string Source, string Kind, string Name, string Owner)> Read()
    {
        KeyValuePair<(HubSource Source, string Topic, string Name), (long At, HubSource Owner)>[] known;
        lock (_lock) known = [.. _refusals];
        var present = new List<(string Source, string Kind, string Name, string Owner)>();
        foreach (var one in known)
        {
            var (source, topic, name) = one.Key;
            // Not under the lock, because this uses the hub's lock.
            var owner = CellKinds.IsLatched(topic) && !source.IsEnded ? source.OtherOwner(CellKinds.Of(topic), name) : null;
            if (owner == null && time.GetElapsedTime(one.Value.At) > Span)
            {
                lock (_lock)
                    if (_refusals.TryGetValue(one.Key, out var newest) && newest == one.Value) _refusals.Remove(one.Key);
                continue;
            }

            present.Add((source.Title, CellKinds.Of(topic), name, (owner ?? one.Value.Owner).Title));
        }

        return [.. present.DistinctBy(one => (one.Source, one.Kind, one.Name))];
    }
}
