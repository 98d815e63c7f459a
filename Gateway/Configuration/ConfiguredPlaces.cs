namespace Nowpose.Gateway.Configuration;

/// <summary>Adds the file and line of an option's entry in the configuration file to messages about that option.</summary>
sealed class ConfiguredPlaces
{
    readonly List<(string Beginning, string Replacement)> _beginnings = [];

    /// <param name="option">The option as written on a command line, such as --tokens.</param>
    /// <param name="paths">The files or folders that the option names. A message that starts with one of them is about this option.</param>
    public void Add(string option, ConfigurationEntry entry, IEnumerable<string> paths)
    {
        var named = entry.Wrong("");
        _beginnings.Add((option + ":", named.TrimEnd()));
        _beginnings.Add((option + " ", named.TrimEnd(' ', ':') + " "));
        // Matches only "PATH: "; a message that starts with "PATH, line 3" already states its place.
        foreach (var path in paths) _beginnings.Add((path + ": ", $"{named}{path}: "));
    }

    /// <summary>Returns the message, preceded by file and line if it is about an entry of the configuration file.</summary>
    public string Place(string complaint)
    {
        foreach (var (beginning, replacement) in _beginnings)
            if (complaint.StartsWith(beginning, StringComparison.Ordinal)) return replacement + complaint[beginning.Length..];
        return complaint;
    }
}
