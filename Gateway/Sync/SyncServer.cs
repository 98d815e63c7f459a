using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway.Clock;

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
    readonly Action<string> _log;
    readonly Action<SyncConnection> _startConnection;
    readonly TcpListener _listener;
    readonly HashSet<SyncConnection> _connections = [];
    readonly Task _accepting;
    bool _isStopped;

    /// <param name="startConnection">Starts a connection's thread; null as it is.</param>
    public SyncServer(
        GatewayOptions options, IControlClock clock, Action<string> log, Action<SyncConnection> startConnection = null)
    {
        _options = options;
        _clock = clock;
        _log = log;
        _startConnection = startConnection ?? (connection => connection.Start());
        _listener = new TcpListener(options.Bind, options.SyncPort);
        if (options.Bind.Equals(IPAddress.IPv6Any))
            _listener.Server.DualMode = true;
        // On Unix .NET sets SO_REUSEADDR by itself when binding, so a restart need not wait for old connections to time out;
        // set here it would also let two gateways share the port.
        Start();
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
            connection.Stop();
        foreach (var connection in open)
            connection.Join();
        _accepting.Wait();
    }

    void Start()
    {
        try
        {
            _listener.Start();
        }
        catch (SocketException e)
        {
            _listener.Dispose();
            throw new InputException($"--sync-port {_options.SyncPort} on {_options.Bind}: {e.Message}", e);
        }
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
        if (!Counters.TryEnter(_options.MaxConnections))
        {
            _log($"sync: refused a connection beyond {_options.MaxConnections}");
            socket.Dispose();
            return;
        }

        var connection = new SyncConnection(socket, _options, _clock, Ended);
        lock (_connections)
        {
            _connections.Add(connection);
            if (_isStopped)
                connection.Stop();
        }

        try
        {
            _startConnection(connection);
        }
        catch (Exception e) when (e is OutOfMemoryException or ThreadStartException)
        {
            // The system has no thread left; it may have one for the next.
            Ended(connection, Closure.Failure, e);
            connection.Stop();
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
