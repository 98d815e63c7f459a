namespace Nowpose.Gateway.Options;

/// <summary>All that is wrong with what the user gave, a line each: who mends a file wants to know it at once.</summary>
public sealed class WrongEntriesException(IReadOnlyList<string> lines) : InputException(string.Join("; ", lines))
{
    public IReadOnlyList<string> Lines { get; } = lines;
}
