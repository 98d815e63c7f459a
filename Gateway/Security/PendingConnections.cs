using System.Net;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Limits the connections that have not been authenticated yet, for each address and in total. Thread-safe.
/// </summary>
/// <remarks>
/// A full address loses its oldest connection, not the new one: behind one NAT address, there may be a headset next to many half-open
/// clients. Connections that have completed a handshake have separate places, so that silent ones cannot take theirs.
/// </remarks>
/// <param name="maxOfAddress">Maximum number of connections of one address, separately before and after the handshake.</param>
/// <param name="maxInAll">Maximum number of connections of all addresses.</param>
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

    /// <param name="evict">
    /// Ends the connection when a newer one takes its place. Called at most once, on the newer one's thread.
    /// </param>
    /// <returns>Dispose it when the connection was authenticated or has ended.</returns>
    public PendingConnection Enter(EndPoint remote, Action evict)
    {
        // Connections with unknown addresses count as one address.
        var connection = new PendingConnection(this, (remote as IPEndPoint)?.Address ?? IPAddress.None, evict);
        PendingConnection evicted;
        lock (_lock)
        {
            if (!_addresses.TryGetValue(connection.Address, out var own)) _addresses.Add(connection.Address, own = ([], []));
            evicted = own.Silent.Count >= maxOfAddress ? own.Silent.First.Value : _all.Count >= maxInAll ? OldestOfAll() : null;
            Remove(evicted);
            // The removal may have removed the address with its last connection.
            _addresses.TryAdd(connection.Address, own);
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

    // Prefers a silent connection.
    PendingConnection OldestOfAll() => _all.FirstOrDefault(one => !one.IsKnown) ?? _all.First?.Value;

    internal void MarkKnown(PendingConnection connection)
    {
        PendingConnection evicted;
        lock (_lock)
        {
            if (connection.IsKnown || connection.OfAddress.List == null) return;
            var own = _addresses[connection.Address];
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
        var (silent, known) = _addresses[connection.Address];
        if (silent.Count == 0 && known.Count == 0) _addresses.Remove(connection.Address);
    }
}
