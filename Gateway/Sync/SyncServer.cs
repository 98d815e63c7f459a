using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Sync;

/// <summary>Responds to sync requests over TCP. Each connection has its own thread.</summary>
/// <remarks>
/// The operating system immediately wakes a thread that blocks in receive. A busy thread pool would read t2 late, which a headset cannot
/// distinguish from a slow network.
/// </remarks>
sealed class SyncServer : IDisposable
{
    static readonly TimeSpan PauseAfterAFailedAccept = TimeSpan.FromMilliseconds(50);

    readonly GatewayOptions _options;
    readonly IControlClock _clock;
    readonly AccessWatch _access;
    readonly Action<string, string> _log;
    readonly Action<ServedSyncConnection> _startConnection;
    readonly TcpListener _listener;
    readonly Func<TcpListener, Task<Socket>> _accept;
    readonly PendingConnections _pending;
    readonly WrongTokens _wrong;
    readonly HashSet<ServedSyncConnection> _connections = [];
    readonly Task _accepting;
    bool _isStopped;

    /// <param name="log">Receives each line and its kind, which has a rate limit of its own.</param>
    /// <param name="startConnection">Starts the thread of a connection; null to call <see cref="ServedSyncConnection.Start"/>.</param>
    /// <param name="accept">Accepts the next connection; null to accept from the listener.</param>
    public SyncServer(
        GatewayOptions options, IControlClock clock, AccessWatch access, WrongTokens wrong, Action<string, string> log,
        Action<ServedSyncConnection> startConnection = null, Func<TcpListener, Task<Socket>> accept = null)
    {
        _options = options;
        _clock = clock;
        _access = access;
        _wrong = wrong;
        _log = log;
        _startConnection = startConnection ?? (connection => connection.Start());
        _accept = accept ?? (listener => listener.AcceptSocketAsync());
        _pending = new PendingConnections(options.MaxPendingConnections);
        _listener = PortListener.Open("--sync-port", options.Bind, options.SyncPort);
        _accepting = Task.Run(AcceptAsync);
    }

    public IPEndPoint EndPoint => (IPEndPoint)_listener.LocalEndpoint;
    public ConnectionCounters Counters { get; } = new();

    /// <summary>Number of connections that are not authenticated yet.</summary>
    public int PendingCount => _pending.Count;

    public void Dispose()
    {
        ServedSyncConnection[] open;
        lock (_connections)
        {
            _isStopped = true;
            open = [.. _connections];
        }

        _listener.Dispose();
        foreach (var connection in open)
            connection.Stop(Closure.Stopped);
        foreach (var connection in open)
            connection.Join();
        _accepting.Wait();
    }

    async Task AcceptAsync()
    {
        while (true)
        {
            try
            {
                var accepted = await _accept(_listener);
                DescriptorLimit.Guard(accepted);
                Serve(accepted);
            }
            catch (Exception e)
            {
                // Catches all exceptions, because the end of this loop would close the port permanently.
                if (Volatile.Read(ref _isStopped))
                    return;
                Counters.CountFailure(e);
                _log(SyncServerMessages.NotAccepted(e.GetType().Name, e.Message), SyncServerMessages.NotAccepted(e.GetType().Name, ""));
                // Pauses, because accepting may fail repeatedly, for example until a file descriptor is free.
                await Task.Delay(PauseAfterAFailedAccept);
            }
        }
    }

    void Serve(Socket socket)
    {
        if (!HasPlace())
        {
            var refused = SyncServerMessages.Refused(_options.MaxConnections);
            _log(AccessMessages.By(refused, (RemoteOf(socket) as IPEndPoint)?.Address, null, null), refused);
            socket.Dispose();
            return;
        }

        ServedSyncConnection connection = null;
        var remote = RemoteOf(socket);
        var place = _pending.Enter(remote, () => Evict(connection));
        connection = new ServedSyncConnection(socket, _options, _clock, _access, _wrong, place, Ended);
        lock (_connections)
        {
            _connections.Add(connection);
            if (_isStopped)
                connection.Stop(Closure.Stopped);
        }

        try
        {
            _startConnection(connection);
        }
        catch (Exception e) when (e is OutOfMemoryException or ThreadStartException)
        {
            // The system cannot start another thread. It may be able to start one for a later connection.
            place.Dispose();
            Ended(connection, Closure.Failure, e);
            connection.Stop(Closure.Failure);
        }
    }

    // Returns whether the server has capacity for a new connection. At the limit, closes the oldest connection that is not authenticated, because the
    // new client may be a headset with a token.
    bool HasPlace() => Counters.TryEnter(_options.MaxConnections, isFinal: false)
        || (_pending.TryEvictOldest() && Counters.TryEnter(_options.MaxConnections, isFinal: false))
        || Counters.TryEnter(_options.MaxConnections);

    void Evict(ServedSyncConnection connection)
    {
        // Counts the connection as ended now, not when its thread ends, because the next connection needs the capacity.
        Ended(connection, Closure.ConnectionLimit, null);
        connection.Stop(Closure.ConnectionLimit);
    }

    static EndPoint RemoteOf(Socket socket)
    {
        try
        {
            return socket.RemoteEndPoint;
        }
        catch (SocketException)
        {
            // The client has already closed the connection.
            return null;
        }
    }

    void Ended(ServedSyncConnection connection, Closure why, Exception cause)
    {
        lock (_connections)
            if (!_connections.Remove(connection)) return;
        Counters.Leave(why);
        if (why is not (Closure.ByPeer or Closure.Stopped))
            _log(
                AccessMessages.By(
                    SyncServerMessages.Closed(why, why == Closure.Failure ? cause : null), connection.Address, connection.Role,
                    _options.LoggedHash(connection.TokenHash)),
                SyncServerMessages.ClosedFor(why));
    }
}
