namespace Nowpose.Gateway.Options;

/// <summary>All errors in the user's input, one line each, so that a file can be corrected at once.</summary>
public sealed class WrongEntriesException(IReadOnlyList<string> lines) : InputException(string.Join("; ", lines))
{
    public IReadOnlyList<string> Lines { get; } = lines;
}
