using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using System.Text;

namespace Nowpose.Tests.Common;

/// <summary>A WebSocket server on loopback whose output a test can control byte by byte.</summary>
sealed class FakeWebSocketServer : IDisposable
{
    readonly TcpListener _listener = new(IPAddress.Loopback, 0);
    readonly List<TcpClient> _clients = [];

    public FakeWebSocketServer() => _listener.Start();

    public int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;

    /// <summary>Accepts one client and responds to its upgrade request.</summary>
    public async Task<WebSocket> AcceptAsync()
    {
        var stream = await AcceptStreamAsync();
        return WebSocket.CreateFromStream(stream, new WebSocketCreationOptions { IsServer = true });
    }

    /// <summary>Accepts one client and returns its stream, on which a test can send frames that no library would send.</summary>
    public async Task<NetworkStream> AcceptStreamAsync() => (NetworkStream)await AcceptStreamAsync(null);

    /// <param name="certificate">Certificate for TLS; null for an unencrypted connection.</param>
    public async Task<Stream> AcceptStreamAsync(X509Certificate2 certificate)
    {
        var client = await _listener.AcceptTcpClientAsync().Bounded();
        lock (_clients) _clients.Add(client);
        client.NoDelay = true;
        Stream stream = client.GetStream();
        if (certificate != null) stream = await EncryptAsync(stream, certificate);
        var head = await ReadHeadAsync(stream);
        var key = head.Split("\r\n").Single(line => line.StartsWith("Sec-WebSocket-Key:", StringComparison.OrdinalIgnoreCase)).Split(": ")[1];
#pragma warning disable CA5350 // RFC 6455 prescribes SHA-1.
        var accept = Convert.ToBase64String(SHA1.HashData(Encoding.ASCII.GetBytes(key + "258EAFA5-E914-47DA-95CA-C5AB0DC85B11")));
#pragma warning restore CA5350
        await stream.WriteAsync(Encoding.ASCII.GetBytes(
            $"HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: {accept}\r\n\r\n"));
        return stream;
    }

    /// <summary>Responds to the first request with the given bytes, regardless of its content.</summary>
    public async Task AnswerAsync(string answer)
    {
        using var client = await _listener.AcceptTcpClientAsync().Bounded();
        await ReadHeadAsync(client.GetStream());
        await client.GetStream().WriteAsync(Encoding.ASCII.GetBytes(answer));
    }

    public void Dispose()
    {
        _listener.Stop();
        lock (_clients)
            foreach (var client in _clients) client.Dispose();
    }

    static async Task<Stream> EncryptAsync(Stream stream, X509Certificate2 certificate)
    {
        var secure = new SslStream(stream);
        await secure.AuthenticateAsServerAsync(certificate);
        return secure;
    }

    static async Task<string> ReadHeadAsync(Stream stream)
    {
        var head = new StringBuilder();
        var one = new byte[1];
        while (!head.ToString().EndsWith("\r\n\r\n", StringComparison.Ordinal))
        {
            await stream.ReadExactlyAsync(one);
            head.Append((char)one[0]);
        }
        return head.ToString();
    }
}
