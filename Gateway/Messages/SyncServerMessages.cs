namespace Nowpose.Gateway.Messages;

/// <summary>Lines about the clock synchronisation in the log.</summary>
static class SyncServerMessages
{
    public static string NotAccepted(string kind, string reason) => $"sync: a connection could not be accepted ({kind}: {reason})";
    public static string Refused(int max) => $"sync: refused a connection, because {max} connections are open, which is the maximum";

    /// <param name="cause">Null if it is unknown or needs no text.</param>
    public static string Closed(Closure why, Exception cause) => cause == null
        ? $"sync: closed a connection (reason: {why})"
        : $"sync: closed a connection (reason: {why}): {cause.GetType().Name}: {cause.Message}";
}
