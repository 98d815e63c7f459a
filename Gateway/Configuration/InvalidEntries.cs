namespace Nowpose.Gateway.Configuration;

/// <summary>The errors in a configuration file, and the keys whose values are therefore not known.</summary>
sealed class InvalidEntries
{
    readonly List<string> _lines = [];
    HashSet<string> _keys = new(StringComparer.Ordinal);
    bool _isAnyUnknown;

    /// <summary>The errors, one line each.</summary>
    public IReadOnlyList<string> Lines => _lines;

    /// <summary>Whether the file has no error that concerns a key.</summary>
    public bool Allow(string key) => !_isAnyUnknown && !_keys.Contains(key);

    /// <param name="key">The key as written in the file, whose value is not known.</param>
    /// <param name="line">The error.</param>
    public void Add(string key, string line)
    {
        _lines.Add(line);
        _keys.Add(key);
    }

    /// <summary>Replaces each key by the known key that it probably means, if any.</summary>
    public void Correct(IReadOnlyCollection<string> known) =>
        _keys = _keys.Select(key => Nearest.Of(key, known)).Where(key => key != null).ToHashSet(StringComparer.Ordinal);

    /// <summary>Adds an error that may concern any key, because a part of the file cannot be read.</summary>
    public void AddUnknown(string line)
    {
        _lines.Add(line);
        _isAnyUnknown = true;
    }
}
