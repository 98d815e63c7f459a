using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Finds the ports whose maximum number of connections is reached. Thread-safe.</summary>
/// <param name="servers">The servers with their names in the state.</param>
/// <param name="max">Maximum number of connections of each server.</param>
sealed class ConnectionLimits((string Name, ConnectionCounters Counters)[] servers, int max, TimeProvider time)
{
    /// <summary>
    /// Time for which the maximum counts as reached after it was reached or a connection was refused. A refused headset connects again sooner.
    /// </summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    // For each server, the number of refusals and the time at the last check that found the maximum or a new refusal; null before.
    readonly (long Refused, long? At)[] _last = new (long, long?)[servers.Length];

    public IReadOnlyList<Condition> Read()
    {
        lock (_lock) return [.. Enumerable.Range(0, servers.Length).Where(IsReached).Select(server => Of(servers[server]))];
    }

    bool IsReached(int server)
    {
        var counters = servers[server].Counters;
        var refused = counters.Refused;
        if (counters.Open >= max || refused > _last[server].Refused) _last[server] = (refused, time.GetTimestamp());
        return _last[server].At is { } at && time.GetElapsedTime(at) < Span;
    }

    Condition Of((string Name, ConnectionCounters Counters) server) => new(
        "connection", server.Name, EventTexts.LimitReached, EventTexts.Connections(max, server.Counters.Refused), Level.Warning)
    {
        Headline = EventTexts.PortLimitReached(server.Name),
        Remedy = EventRemedies.Connections,
    };
}
