using System.Net;
using System.Net.Sockets;

namespace Nowpose.Headless.Tests;

/// <summary>A server that accepts one connection and never responds.</summary>
sealed class SilentServer : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    TcpClient _client;

    public SilentServer() => _listener.Start();

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;
    public bool HasCaller => _listener.Pending();

    /// <summary>Waits until a client has connected and sent data.</summary>
    public async Task AskedAsync()
    {
        _client = await _listener.AcceptTcpClientAsync().Bounded();
        await _client.GetStream().ReadAsync(new byte[1]).AsTask().Bounded();
    }

    /// <summary>Waits until the client has closed the connection.</summary>
    public async Task EndAsync()
    {
        var received = new byte[1000];
        try
        {
            while (await _client.GetStream().ReadAsync(received).AsTask().Bounded() > 0) { }
        }
        catch (IOException)
        {
            // The connection was reset.
        }
    }

    public void Dispose()
    {
        _client?.Dispose();
        _listener.Stop();
    }
}
