using System.Net;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Limits the number of connections that are not authenticated yet, for each address (<see cref="ClientNetwork"/>) and in total. Thread-safe.
/// </summary>
/// <remarks>
/// At the limit of an address, the oldest connection is closed instead of the new one, because the same address (NAT) may belong to a headset
/// and to many clients that never complete their connection. Connections after the handshake are counted separately, so that silent
/// connections cannot replace them.
/// </remarks>
/// <param name="maxOfAddress">Maximum number of connections of one address; applies separately before and after the handshake.</param>
/// <param name="maxInAll">Maximum number of connections of all addresses together.</param>
sealed class PendingConnections(int maxOfAddress, int maxInAll = int.MaxValue)
{
    readonly Lock _lock = new();
    readonly Dictionary<IPAddress, (LinkedList<PendingConnection> Silent, LinkedList<PendingConnection> Known)> _addresses = [];
    readonly LinkedList<PendingConnection> _all = [];

    /// <summary>Number of current connections.</summary>
    internal int Count
    {
        get
        {
            lock (_lock) return _all.Count;
        }
    }

    /// <summary>Adds a connection.</summary>
    /// <param name="remote">Endpoint of the client.</param>
    /// <param name="evict">
    /// Ends the connection when a newer connection replaces it. Called at most once, on the thread of the newer connection.
    /// </param>
    /// <returns>An object to dispose when the connection is authenticated or has ended.</returns>
    public PendingConnection Enter(EndPoint remote, Action evict)
    {
        // Connections with unknown addresses are counted as one address.
        var connection = new PendingConnection(this, (remote as IPEndPoint)?.Address ?? IPAddress.None, evict);
        PendingConnection evicted;
        lock (_lock)
        {
            if (!_addresses.TryGetValue(connection.Network, out var own)) _addresses.Add(connection.Network, own = ([], []));
            evicted = own.Silent.Count >= maxOfAddress ? own.Silent.First.Value : _all.Count >= maxInAll ? OldestOfAll() : null;
            Remove(evicted);
            // Adds the address again if Remove has removed it with its last connection.
            _addresses.TryAdd(connection.Network, own);
            own.Silent.AddLast(connection.OfAddress);
            _all.AddLast(connection.OfAll);
        }

        evicted?.Evict();
        return connection;
    }

    /// <summary>Ends the oldest connection of all addresses.</summary>
    /// <returns>False if there is none.</returns>
    public bool TryEvictOldest()
    {
        PendingConnection evicted;
        lock (_lock) Remove(evicted = OldestOfAll());
        evicted?.Evict();
        return evicted != null;
    }

    // Prefers connections that have not completed their handshake.
    PendingConnection OldestOfAll() => _all.FirstOrDefault(one => !one.IsKnown) ?? _all.First?.Value;

    internal void MarkKnown(PendingConnection connection)
    {
        PendingConnection evicted;
        lock (_lock)
        {
            if (connection.IsKnown || connection.OfAddress.List == null) return;
            var own = _addresses[connection.Network];
            evicted = own.Known.Count >= maxOfAddress ? own.Known.First.Value : null;
            own.Silent.Remove(connection.OfAddress);
            own.Known.AddLast(connection.OfAddress);
            connection.IsKnown = true;
            Remove(evicted);
        }

        evicted?.Evict();
    }

    internal void Leave(PendingConnection connection)
    {
        lock (_lock) Remove(connection);
    }

    // Does nothing for a connection that is not in the list.
    void Remove(PendingConnection connection)
    {
        if (connection?.OfAddress.List is not { } list) return;
        list.Remove(connection.OfAddress);
        _all.Remove(connection.OfAll);
        var (silent, known) = _addresses[connection.Network];
        if (silent.Count == 0 && known.Count == 0) _addresses.Remove(connection.Network);
    }
}
