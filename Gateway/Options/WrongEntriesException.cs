namespace Nowpose.Gateway.Options;

/// <summary>The exception for all errors in a user's input, one line each, so that the user can correct all of them at once.</summary>
public sealed class WrongEntriesException(IReadOnlyList<string> lines) : InputException(string.Join("; ", lines))
{
    public IReadOnlyList<string> Lines { get; } = lines;
}
