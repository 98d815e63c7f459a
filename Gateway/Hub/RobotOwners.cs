namespace Nowpose.Gateway.Hub;

/// <summary>The sources of the names on the robots' topics: joints, planned joints, and the robot itself on its description. Not thread-safe.</summary>
sealed class RobotOwners
{
    readonly Dictionary<(string Topic, string Name), HubSource> _owners = [];

    /// <summary>Gets the source of a name that has one.</summary>
    /// <param name="topic">The topic, with the robot's namespace.</param>
    public HubSource this[string topic, string name] => _owners[(topic, name)];

    /// <summary>Returns the first name that belongs to another source; null if there is none.</summary>
    public string FindTaken(HubSource source, string topic, string[] names) =>
        Array.Find(names, name => _owners.TryGetValue((topic, name), out var owner) && owner != source);

    /// <summary>Makes a source the owner of names.</summary>
    public void Take(HubSource source, string topic, string[] names)
    {
        foreach (var name in names) _owners[(topic, name)] = source;
    }

    /// <summary>Releases the names of a source.</summary>
    /// <param name="topic">Topic of the names; null for all topics.</param>
    public void Release(HubSource source, string topic)
    {
        foreach (var (key, _) in _owners.Where(entry => entry.Value == source && (topic == null || entry.Key.Topic == topic)).ToList()) _owners.Remove(key);
    }
}
