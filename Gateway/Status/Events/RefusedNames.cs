using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Names of adapters and headsets whose reports are refused because another client uses the name. Thread-safe; bounded.</summary>
/// <remarks>
/// A client that reconnects is refused until the name of its former connection is free. A name therefore counts as refused only if the refusals continue for
/// longer than <see cref="NamesInUse.FreeAfter"/>.
/// </remarks>
sealed class RefusedNames(TimeProvider time)
{
    /// <summary>Maximum number of names.</summary>
    const int MaxNames = 64;

    /// <summary>Time for which a name counts as refused after the last refusal. Clients report once per second.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<string, (HubSource Client, long First, long Last)> _names = [];

    /// <summary>Adds a refusal, or repeats it.</summary>
    /// <param name="client">The client that was refused.</param>
    /// <param name="name">The name in its report.</param>
    public void Add(HubSource client, string name)
    {
        lock (_lock)
        {
            RemoveOld();
            var now = time.GetTimestamp();
            if (_names.TryGetValue(name, out var known)) _names[name] = (client, known.First, now);
            else if (_names.Count < MaxNames) _names.Add(name, (client, now, now));
        }
    }

    /// <summary>Gets each name with the title of the newest client that was refused.</summary>
    public IReadOnlyList<(string Name, string Client)> Read()
    {
        lock (_lock)
        {
            RemoveOld();
            return [.. _names.Where(one => time.GetElapsedTime(one.Value.First, one.Value.Last) > NamesInUse.FreeAfter).Select(one => (one.Key, one.Value.Client.Title))];
        }
    }

    void RemoveOld()
    {
        foreach (var (name, refused) in _names)
            if (time.GetElapsedTime(refused.Last) > Span) _names.Remove(name);
    }
}
