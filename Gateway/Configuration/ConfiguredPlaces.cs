namespace Nowpose.Gateway.Configuration;

/// <summary>Maps options to their place in the configuration file, so that messages can state it.</summary>
sealed class ConfiguredPlaces
{
    readonly List<(string Beginning, string Replacement)> _beginnings = [];

    /// <param name="option">The option as typed.</param>
    /// <param name="paths">The files or folders that it names. Other values do not identify the option in a message.</param>
    public void Add(string option, ConfigurationEntry entry, IEnumerable<string> paths)
    {
        var named = entry.Wrong("");
        _beginnings.Add((option + ":", named.TrimEnd()));
        _beginnings.Add((option + " ", named.TrimEnd(' ', ':') + " "));
        // "PATH, line 3" is already a place.
        foreach (var path in paths) _beginnings.Add((path + ": ", $"{named}{path}: "));
    }

    /// <summary>Returns the message, with its place if it is about an entry of the file.</summary>
    public string Place(string complaint)
    {
        foreach (var (beginning, replacement) in _beginnings)
            if (complaint.StartsWith(beginning, StringComparison.Ordinal)) return replacement + complaint[beginning.Length..];
        return complaint;
    }
}
