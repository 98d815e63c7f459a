namespace Nowpose.Gateway.Status.Events;

/// <summary>
/// Finds the ports whose maximum number of connections is reached, and those that refuse connections because too few file descriptors are left. Thread-safe.
/// </summary>
/// <param name="servers">The servers with their names in the state.</param>
/// <param name="max">Maximum number of connections of each server.</param>
sealed class ConnectionLimits((string Name, ConnectionCounters Counters)[] servers, int max, TimeProvider time)
{
    /// <summary>
    /// Time for which a limit counts as reached after it was reached or a connection was refused. A refused headset connects again sooner.
    /// </summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    // For each server, the number of refusals and the time at the last check that found the limit or a new refusal; null before.
    readonly (long Refused, long? At)[] _full = new (long, long?)[servers.Length], _noDescriptor = new (long, long?)[servers.Length];
    readonly (long Refused, long? At)[] _ofSource = new (long, long?)[servers.Length];

    public IReadOnlyList<Condition> Read()
    {
        lock (_lock) return [.. Enumerable.Range(0, servers.Length).SelectMany(Of)];
    }

    IEnumerable<Condition> Of(int server)
    {
        var (name, counters) = servers[server];
        if (IsReached(ref _full[server], counters.Refused, counters.Open >= max))
            yield return new("connection", name, EventTexts.LimitReached, EventTexts.Connections(max, counters.Refused), Level.Warning)
            {
                Headline = EventTexts.PortLimitReached(name),
                Remedy = EventRemedies.Connections,
            };
        var refusedOfSources = counters[Closure.SourceLimit];
        if (IsReached(ref _ofSource[server], refusedOfSources))
            yield return new("connection", name, EventTexts.SourceLimitReached, EventTexts.RefusedOfSources(refusedOfSources), Level.Warning)
            {
                Headline = EventTexts.PortSourceLimitReached(name),
                Remedy = EventRemedies.ConnectionsOfSource,
            };
        var refused = counters[Closure.DescriptorLimit];
        if (IsReached(ref _noDescriptor[server], refused))
            yield return new("connection", name, EventTexts.NoDescriptor, EventTexts.RefusedForDescriptors(refused), Level.Warning)
            {
                Headline = EventTexts.PortWithoutDescriptor(name),
                Remedy = EventRemedies.Descriptors,
            };
    }

    bool IsReached(ref (long Refused, long? At) last, long refused, bool isFull = false)
    {
        if (isFull || refused > last.Refused) last = (refused, time.GetTimestamp());
        return last.At is { } at && time.GetElapsedTime(at) < Span;
    }
}
