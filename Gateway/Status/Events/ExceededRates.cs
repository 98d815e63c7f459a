using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Clients of which the gateway drops messages, because they send more than their role allows. Thread-safe; bounded.</summary>
sealed class ExceededRates(TimeProvider time)
{
    /// <summary>Maximum number of clients.</summary>
    const int MaxClients = 64;

    /// <summary>Time for which a client counts as too fast after its last dropped message.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<string, (string Rule, long At)> _clients = [];

    /// <summary>Adds a dropped message of a client.</summary>
    /// <param name="rule">The rule that the client breaks, with the maximum rate and the remedy.</param>
    public void Add(HubSource client, string rule)
    {
        lock (_lock)
            if (_clients.Count < MaxClients || _clients.ContainsKey(client.Title)) _clients[client.Title] = (rule, time.GetTimestamp());
    }

    /// <summary>Gets the titles of the clients, each with the rule that it breaks.</summary>
    public IReadOnlyList<(string Client, string Rule)> Read()
    {
        lock (_lock)
        {
            foreach (var (client, dropped) in _clients)
                if (time.GetElapsedTime(dropped.At) > Span) _clients.Remove(client);
            return [.. _clients.Select(one => (one.Key, one.Value.Rule))];
        }
    }
}
