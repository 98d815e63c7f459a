namespace Nowpose.UnityPlayer;

/// <summary>One entry of the console of a player.</summary>
/// <param name="Type">Severity of the entry.</param>
/// <param name="Message">Text of the entry.</param>
/// <param name="Exception">The exception that a script has thrown or logged; null if the entry is a message.</param>
/// <param name="Context">The object to which the entry refers; null if there is none.</param>
public readonly record struct PlayerLogEntry(LogType Type, string Message, Exception Exception, Object Context)
{
    public override string ToString() => $"{Type}: {Message}{(Exception == null ? "" : "\n" + Exception)}";
}
