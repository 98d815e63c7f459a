using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Sync;

/// <summary>Answers sync exchanges over TCP, each connection on a thread of its own.</summary>
/// <remarks>
/// A thread that blocks in receive is woken by the system itself; a thread pool that is busy elsewhere would stamp t2 late, and
/// the headset could not tell that from a slow network.
/// </remarks>
sealed class SyncServer : IDisposable
{
    static readonly TimeSpan PauseAfterAFailedAccept = TimeSpan.FromMilliseconds(50);

    readonly GatewayOptions _options;
    readonly IControlClock _clock;
    readonly AccessWatch _access;
    readonly Action<string> _log;
    readonly Action<SyncConnection> _startConnection;
    readonly TcpListener _listener;
    readonly Newcomers _newcomers;
    readonly HashSet<SyncConnection> _connections = [];
    readonly Task _accepting;
    bool _isStopped;

    /// <param name="startConnection">Starts a connection's thread; null as it is.</param>
    public SyncServer(
        GatewayOptions options, IControlClock clock, AccessWatch access, Action<string> log, Action<SyncConnection> startConnection = null)
    {
        _options = options;
        _clock = clock;
        _access = access;
        _log = log;
        _startConnection = startConnection ?? (connection => connection.Start());
        _newcomers = new Newcomers(options.MaxNewcomers);
        _listener = PortListener.Open("--sync-port", options.Bind, options.SyncPort);
        _accepting = Task.Run(AcceptAsync);
    }

    public IPEndPoint EndPoint => (IPEndPoint)_listener.LocalEndpoint;
    public ConnectionCounters Counters { get; } = new();

    public void Dispose()
    {
        SyncConnection[] open;
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
                Serve(await _listener.AcceptSocketAsync());
            }
            catch (Exception e) when (e is SocketException or ObjectDisposedException or InvalidOperationException)
            {
                // Stopped, or a peer that went before it was accepted.
                if (Volatile.Read(ref _isStopped))
                    return;
                // Out of handles, say: not at full speed until there are some again.
                await Task.Delay(PauseAfterAFailedAccept);
            }
        }
    }

    void Serve(Socket socket)
    {
        // First: whoever is refused for its address was never let in, and is not counted as such.
        if (_newcomers.TryEnter(RemoteOf(socket)) is not { } place)
        {
            _log($"sync: refused a connection of an address with {_options.MaxNewcomers} that said nothing yet");
            Counters.Count(Closure.ConnectionLimit);
            socket.Dispose();
            return;
        }

        if (!Counters.TryEnter(_options.MaxConnections))
        {
            _log($"sync: refused a connection beyond {_options.MaxConnections}");
            place.Dispose();
            socket.Dispose();
            return;
        }

        var connection = new SyncConnection(socket, _options, _clock, _access, place, Ended);
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
            // The system has no thread left; it may have one for the next.
            Ended(connection, Closure.Failure, e);
            connection.Stop(Closure.Failure);
        }
    }

    static EndPoint RemoteOf(Socket socket)
    {
        try
        {
            return socket.RemoteEndPoint;
        }
        catch (SocketException)
        {
            // Gone already.
            return null;
        }
    }

    void Ended(SyncConnection connection, Closure why, Exception cause)
    {
        lock (_connections)
            _connections.Remove(connection);
        Counters.Leave(why);
        if (why is not (Closure.ByPeer or Closure.Stopped))
            _log($"sync: closed a connection, {why}{(why == Closure.Failure ? $": {cause.GetType().Name}: {cause.Message}" : "")}");
    }
}
