using System.Net;

namespace Nowpose.Gateway.Security;

/// <summary>A connection that has not been authenticated yet. Thread-safe.</summary>
sealed class PendingConnection : IDisposable
{
    readonly PendingConnections _all;

    public PendingConnection(PendingConnections all, IPAddress address, Action evict)
    {
        _all = all;
        (Address, Network) = (address, ClientNetwork.Of(address));
        Evict = evict;
        OfAddress = new LinkedListNode<PendingConnection>(this);
        OfAll = new LinkedListNode<PendingConnection>(this);
    }

    public IPAddress Address { get; }
    public IPAddress Network { get; }
    public Action Evict { get; }
    public LinkedListNode<PendingConnection> OfAddress { get; }
    public LinkedListNode<PendingConnection> OfAll { get; }
    public bool IsKnown { get; set; }

    /// <summary>Records that the connection has completed its TLS handshake or sent a complete request.</summary>
    public void CompleteHandshake() => _all.MarkKnown(this);

    public void Dispose() => _all.Leave(this);
}
