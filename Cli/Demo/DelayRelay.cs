using System.Net;
using System.Net.Sockets;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>A TCP relay on loopback that delays each direction of each connection by a network profile and keeps the order.</summary>
sealed class DelayRelay : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    readonly IPEndPoint _target;
    readonly NetworkProfile _network;
    readonly List<RelayedConnection> _connections = [];
    readonly Thread _accepting;
    int _seed;

    /// <param name="seed">The seed from which the seed of each connection and direction is derived.</param>
    public DelayRelay(IPEndPoint target, NetworkProfile network, int seed)
    {
        _target = target;
        _network = network;
        _seed = seed;
        _listener.Start();
        _accepting = new Thread(Accept) { IsBackground = true, Name = "relay accept" };
        _accepting.Start();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    public void Dispose()
    {
        _listener.Stop();
        // The list no longer changes after this.
        _accepting.Join();
        foreach (var connection in _connections) connection.Dispose();
    }

    void Accept()
    {
        try
        {
            while (true) Relay(_listener.AcceptTcpClient());
        }
        catch (Exception end) when (end is SocketException or ObjectDisposedException or InvalidOperationException)
        {
            // The listener was stopped.
        }
    }

    void Relay(TcpClient headset)
    {
        var gateway = new TcpClient();
        try
        {
            gateway.Connect(_target);
            headset.NoDelay = gateway.NoDelay = true;
            _connections.Add(new RelayedConnection(headset, gateway, _network.Up(_seed++), _network.Down(_seed++)));
        }
        catch (SocketException)
        {
            // The gateway is not reachable. The headset sees its connection closed, as with a real router.
            headset.Dispose();
            gateway.Dispose();
        }
    }
}
