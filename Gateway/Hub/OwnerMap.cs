namespace Nowpose.Gateway.Hub;

/// <summary>The sources that own names. A name belongs to one source at a time. Not thread-safe.</summary>
/// <typeparam name="TName">A frame or signal of the cell, or a name on a topic: a joint, a planned joint or "the robot".</typeparam>
sealed class OwnerMap<TName>
{
    readonly Dictionary<TName, HubSource> _owners = [];

    /// <summary>Number of names that have an owner.</summary>
    public int Count => _owners.Count;

    /// <summary>Gets the number of names that a source owns.</summary>
    public int CountOf(HubSource source) => _owners.Values.Count(owner => owner == source);

    /// <summary>Gets the owner of a name; null if there is none.</summary>
    public HubSource this[TName name] => _owners.GetValueOrDefault(name);

    /// <summary>Gets the owner of a name, if it is another source; null otherwise.</summary>
    public HubSource OtherThan(HubSource source, TName name) => this[name] is { } owner && owner != source ? owner : null;

    /// <summary>Makes a source the owner of a name.</summary>
    public void Take(HubSource source, TName name) => _owners[name] = source;

    /// <summary>Releases a name.</summary>
    public void Release(TName name) => _owners.Remove(name);

    /// <summary>Releases the names of a source that fulfil a condition.</summary>
    /// <returns>The released names.</returns>
    public IReadOnlyCollection<TName> Release(HubSource source, Predicate<TName> isReleased)
    {
        HashSet<TName> released = [.. _owners.Where(one => one.Value == source && isReleased(one.Key)).Select(one => one.Key)];
        foreach (var name in released) _owners.Remove(name);
        return released;
    }
}
