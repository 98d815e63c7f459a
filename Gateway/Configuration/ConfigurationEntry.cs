namespace Nowpose.Gateway.Configuration;

/// <summary>One line of a configuration file: an option and its value.</summary>
/// <param name="Place">File and line of the entry, for messages.</param>
sealed record ConfigurationEntry(string Key, IReadOnlyList<string> Values, bool IsList, string Place)
{
    public string Wrong(string what) => $"{Place}: {Key}: {what}";
}
