namespace Nowpose.Gateway.Messages;

/// <summary>Responses to connections and requests beyond a limit, and error messages about the limits.</summary>
static class LimitMessages
{
    /// <param name="count">Number of equal lines that were not logged.</param>
    public static string MoreLines(string line, int count) => $"{line} ({count} more)";

    public static string Connections(int max) => $"no more than {max} connections are allowed";

    /// <param name="max">Maximum number of connections of a source.</param>
    public static string ConnectionsOfSource(int max) =>
        $"no more than {max} connections to both ports are allowed with the token of one source from one address, a quarter of those of all sources; "
        + "close some, give each source its own token, or increase --max-connections";

    public static string Requests(int max) => $"no more than {max} requests a second are allowed";

    public static string NoDescriptor(ulong number, ulong allowed, ulong spare) =>
        $"connection closed: its file descriptor {number} is one of the last {spare} of {allowed}, which are kept free; raise the limit on open "
        + "files (ulimit -n, or LimitNOFILE= of the systemd unit) or reduce --max-connections";

    public static string BodyBytes(int max) => $"the request body is too long; no more than {max} bytes are allowed";

    /// <param name="possible">Maximum number of connections for this limit; below 1 if none is possible.</param>
    public static string TooFewDescriptors(int connections, long needed, ulong allowed, long possible) =>
        $"--max-connections {connections}: two ports with this number of connections need {needed} file descriptors, and the system allows "
        + $"{allowed}; {(possible < 1 ? "" : $"use 1 to {possible}, or ")}raise the limit to {needed} (ulimit -n, LimitNOFILE= of the systemd unit, "
        + "--ulimit nofile= of the container)";
}
