using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Names of adapters and headsets whose reports are refused because another client uses the name. Thread-safe; bounded.</summary>
/// <remarks>
/// A client that reconnects is refused until the name of its former connection is free. A name therefore counts as refused only if the refusals of
/// one connection continue for longer than <see cref="NamesInUse.FreeAfter"/>.
/// </remarks>
sealed class RefusedNames(TimeProvider time)
{
    /// <summary>Maximum number of names of clients.</summary>
    const int MaxRefusals = 64;

    /// <summary>Time for which a name counts as refused after the last refusal. Clients report once per second.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<(string Name, HubSource Client), (long First, long Last)> _refusals = [];

    /// <summary>Adds a refusal, or repeats it.</summary>
    /// <param name="client">The client that was refused.</param>
    /// <param name="name">The name in its report.</param>
    public void Add(HubSource client, string name)
    {
        lock (_lock)
        {
            RemoveOld();
            var (key, now) = ((name, client), time.GetTimestamp());
            if (_refusals.TryGetValue(key, out var known)) _refusals[key] = (known.First, now);
            else if (_refusals.Count < MaxRefusals) _refusals.Add(key, (now, now));
        }
    }

    /// <summary>Gets each name with the title of the newest client that was refused.</summary>
    public IReadOnlyList<(string Name, string Client)> Read()
    {
        lock (_lock)
        {
            RemoveOld();
            return [.. _refusals.Where(one => Lasts(one.Value)).OrderByDescending(one => one.Value.Last)
                .DistinctBy(one => one.Key.Name).Select(one => (one.Key.Name, one.Key.Client.Title))];
        }
    }

    void RemoveOld()
    {
        // The refusals of a closed connection do not continue.
        foreach (var (key, refused) in _refusals)
            if (time.GetElapsedTime(refused.Last) > Span || (key.Client.IsEnded && !Lasts(refused))) _refusals.Remove(key);
    }

    bool Lasts((long First, long Last) refused) => time.GetElapsedTime(refused.First, refused.Last) > NamesInUse.FreeAfter;
}
