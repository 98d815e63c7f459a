using System.Net;
using System.Net.Sockets;

namespace Nowpose.Tests.Common;

/// <summary>A TCP server on loopback that serves one connection at a time by calling a function of the test.</summary>
sealed class FakeTcpServer : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    readonly Action<NetworkStream> _serve;
    int _connections;

    public FakeTcpServer(Action<NetworkStream> serve)
    {
        _serve = serve;
        _listener.Start();
        new Thread(Serve) { IsBackground = true }.Start();
    }

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>Number of connections accepted so far.</summary>
    public int Connections => Volatile.Read(ref _connections);

    public void Dispose() => _listener.Stop();

    void Serve()
    {
        try
        {
            while (true)
            {
                using var client = _listener.AcceptTcpClient();
                Interlocked.Increment(ref _connections);
                ServeOne(client);
            }
        }
        catch (Exception end) when (end is SocketException or InvalidOperationException)
        {
            // The listener was stopped.
        }
    }

    void ServeOne(TcpClient client)
    {
        try
        {
            _serve(client.GetStream());
        }
        catch (IOException)
        {
            // The client disconnected; the server continues with the next one.
        }
    }
}
