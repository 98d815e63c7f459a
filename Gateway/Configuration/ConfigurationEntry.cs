namespace Nowpose.Gateway.Configuration;

/// <summary>One entry of a configuration file: an option and its value or list of values.</summary>
/// <param name="Place">File and first line of the entry, for messages.</param>
sealed record ConfigurationEntry(string Key, IReadOnlyList<string> Values, bool IsList, string Place)
{
    public string Wrong(string what) => $"{Place}: {Key}: {what}";
}
