namespace Nowpose.Gateway.Configuration;

/// <summary>The errors in a configuration file, and the keys whose values are therefore not known.</summary>
sealed class InvalidEntries
{
    readonly List<string> _lines = [];
    readonly HashSet<string> _keys = new(StringComparer.Ordinal);
    bool _isAnyUnknown;

    /// <summary>The errors, one line each.</summary>
    public IReadOnlyList<string> Lines => _lines;

    /// <summary>Whether the file has no error that concerns a key.</summary>
    public bool Allow(string key) => !_isAnyUnknown && !_keys.Contains(key);

    /// <param name="key">The key whose value is not known; null if the entry sets none.</param>
    public void Add(string key, string line)
    {
        _lines.Add(line);
        if (key != null) _keys.Add(key);
    }

    /// <summary>Adds an error that may concern any key, because a part of the file cannot be read.</summary>
    public void AddUnknown(string line)
    {
        _lines.Add(line);
        _isAnyUnknown = true;
    }
}
