using Nowpose.Signals;

namespace Nowpose.Gateway.Hub;

/// <summary>
/// The newest values of frames or signals that were refused because another source owns them, or because they are invalid. Such a value is sent only
/// once, so it is published, or reported if it is invalid, when the other source ends. Not thread-safe.
/// </summary>
/// <typeparam name="TValue">A signal, or the refused poses of a stationary frame.</typeparam>
/// <param name="stampOf">Returns the time stamp of a value. A stationary frame without a time stamp is older than one that has a time stamp.</param>
sealed class RefusedValues<TValue>(Func<TValue, ControlTime> stampOf)
{
    // In the order of the refusals.
    readonly OrderedDictionary<(string Name, HubSource Source), TValue> _newest = [];

    /// <summary>Keeps a value instead of an earlier one of the same source, unless newer ones have overtaken the value on the network.</summary>
    public void Keep(HubSource source, string name, TValue value)
    {
        if (_newest.TryGetValue((name, source), out var kept) && LateValues.IsOvertaken(stampOf(value), stampOf(kept))) return;
        Remove(source, name);
        _newest.Add((name, source), value);
    }

    /// <summary>Gets or sets the value of a source, which keeps its place in the order of the refusals; <c>default</c> if there is none.</summary>
    public TValue this[HubSource source, string name]
    {
        get => _newest.GetValueOrDefault((name, source));
        set => _newest[(name, source)] = value;
    }

    /// <summary>Removes the value of a source that has sent another value since, which replaces it.</summary>
    public void Remove(HubSource source, string name) => _newest.Remove((name, source));

    /// <summary>Removes all values of a source that ends.</summary>
    public void Remove(HubSource source) => Remove(_newest.Keys.Where(one => one.Source == source));

    /// <summary>
    /// Removes the newest value of each name that no longer has a source, and publishes it. If a value breaks a limit of the cell, the name still has no
    /// source, and the next value follows.
    /// </summary>
    /// <param name="owners">The sources of the frames or signals.</param>
    /// <param name="publish">Publishes the values of a source, in the order of their time stamps.</param>
    public void PublishFree(OwnerMap<string> owners, Action<HubSource, IEnumerable<TValue>> publish)
    {
        while (_newest.Count > 0)
        {
            var values = _newest.Where(one => owners[one.Key.Name] == null).OrderBy(one => stampOf(one.Value))
                .Reverse().DistinctBy(one => one.Key.Name).Reverse().ToArray();
            if (values.Length == 0) return;
            Remove(values.Select(one => one.Key));
            foreach (var ofSource in values.GroupBy(one => one.Key.Source, one => one.Value)) publish(ofSource.Key, ofSource);
        }
    }

    void Remove(IEnumerable<(string Name, HubSource Source)> keys)
    {
        foreach (var key in keys.ToArray()) _newest.Remove(key);
    }
}
