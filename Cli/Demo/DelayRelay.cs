using System.Net;
using System.Net.Sockets;
using Nowpose.Simulation;

namespace Nowpose.Cli.Demo;

/// <summary>A TCP relay on loopback. Delays the data in each direction as defined by a network profile, and preserves their order.</summary>
sealed class DelayRelay : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    readonly IPEndPoint _target;
    readonly NetworkProfile _network;
    readonly List<RelayedConnection> _connections = [];
    readonly Thread _accepting;
    int _seed;

    /// <param name="seed">Base of the seeds; each connection and direction derives its own seed from it.</param>
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
        // The list no longer changes after the accepting thread has ended.
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
            // Expected: Dispose has stopped the listener.
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
            // The gateway is not reachable. The relay closes the headset's connection, as a real router does.
            headset.Dispose();
            gateway.Dispose();
        }
    }
}
