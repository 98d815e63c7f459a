namespace Nowpose.Gateway.Configuration;

/// <summary>Where in the configuration file each option stands: a complaint about one then says so.</summary>
sealed class ConfiguredPlaces
{
    readonly List<(string Beginning, string Told)> _beginnings = [];

    /// <param name="option">As it is typed.</param>
    /// <param name="paths">What it names files or folders by; others are not told by their value.</param>
    public void Add(string option, ConfigurationEntry entry, IEnumerable<string> paths)
    {
        var named = entry.Wrong("");
        _beginnings.Add((option + ":", named.TrimEnd()));
        _beginnings.Add((option + " ", named.TrimEnd(' ', ':') + " "));
        // "PATH, line 3" is a place by itself.
        foreach (var path in paths) _beginnings.Add((path + ": ", $"{named}{path}: "));
    }

    /// <summary>The same complaint, with its place where it is about something of the file.</summary>
    public string Place(string complaint)
    {
        foreach (var (beginning, told) in _beginnings)
            if (complaint.StartsWith(beginning, StringComparison.Ordinal)) return told + complaint[beginning.Length..];
        return complaint;
    }
}
