namespace Nowpose.Gateway.Messages;

/// <summary>Log lines about the clock synchronisation.</summary>
static class SyncServerMessages
{
    public static string NotAccepted(string kind, string reason) => $"sync: a connection could not be accepted ({kind}: {reason})";
    public static string Refused(int max) => $"sync: refused a connection, because {max} connections are open, which is the maximum";

    /// <param name="cause">The exception that ended the connection; null if it is unknown or need not be logged.</param>
    public static string Closed(Closure why, Exception cause) => cause == null
        ? ClosedFor(why) : $"{ClosedFor(why)}: {cause.GetType().Name}: {cause.Message}";

    public static string ClosedFor(Closure why) => $"sync: closed a connection (reason: {why})";
}
