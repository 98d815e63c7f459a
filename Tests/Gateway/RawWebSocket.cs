using System.Net.Sockets;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Sends and receives any bytes and frames on the WebSocket port, including invalid ones and control frames.</summary>
sealed class RawWebSocket : IDisposable
{
    /// <summary>The header fields that request a WebSocket.</summary>
    public const string Upgrade = "Connection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\n"
        + "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n";

    public const int Text = 1;
    public const int Close = 8;
    public const int Ping = 9;
    public const int Pong = 10;

    readonly TcpClient _tcp = new() { NoDelay = true };
    Stream _stream;

    /// <summary>The stream of the connection, for tests that read and write the bytes themselves.</summary>
    public Stream Stream => _stream;

    /// <summary>Number of bytes that can be read without waiting.</summary>
    public int Available => _tcp.Available;

    /// <summary>Shuts down the sending direction of the connection; data can still be received.</summary>
    public void EndSending()
    {
        try
        {
            _tcp.Client.Shutdown(SocketShutdown.Send);
        }
        catch (SocketException)
        {
            // The gateway has already closed the connection.
        }
    }

    /// <param name="receiveBytes">Size of the socket's receive buffer; 0 keeps the default of the system.</param>
    public static async Task<RawWebSocket> ConnectAsync(GatewayServer gateway, int receiveBytes = 0)
    {
        var raw = new RawWebSocket();
        if (receiveBytes > 0) raw._tcp.ReceiveBufferSize = receiveBytes;
        await raw._tcp.ConnectAsync(gateway.WebSocketEndPoint).Bounded();
        raw._stream = raw._tcp.GetStream();
        return raw;
    }

    public static async Task<RawWebSocket> OpenAsync(GatewayServer gateway, string headers = "", int receiveBytes = 0)
    {
        var raw = await ConnectAsync(gateway, receiveBytes);
        Assert.That(await raw.RequestAsync(Upgrade + headers), Does.StartWith("HTTP/1.1 101 "));
        return raw;
    }

    /// <summary>Sends an HTTP request and returns the header of the response.</summary>
    public async Task<string> RequestAsync(string headers = "", string request = "GET /")
    {
        await SendAsync(Encoding.ASCII.GetBytes($"{request} HTTP/1.1\r\nHost: localhost\r\n{headers}\r\n"));
        var head = new StringBuilder();
        while (!head.ToString().EndsWith("\r\n\r\n", StringComparison.Ordinal))
            head.Append((char)(await ReadAsync(1))[0]);
        return head.ToString();
    }

    /// <summary>Sends a message or control frame in one frame. The mask is zero, so the payload bytes do not change (RFC 6455, 5.2).</summary>
    public Task SendFrameAsync(int opcode, params byte[] payload) =>
        SendAsync([(byte)(0x80 | opcode), (byte)(0x80 | payload.Length), 0, 0, 0, 0, .. payload]);

    /// <summary>Sends a text message of 126 to 65535 bytes in one frame with a zero mask.</summary>
    public Task SendTextAsync(string text)
    {
        var payload = Encoding.UTF8.GetBytes(text);
        Assert.That(payload, Has.Length.InRange(126, 65535));
        return SendAsync([0x80 | Text, 0x80 | 126, (byte)(payload.Length >> 8), (byte)payload.Length, 0, 0, 0, 0, .. payload]);
    }

    public async Task<(int Opcode, byte[] Payload)> ReceiveFrameAsync()
    {
        var header = await ReadAsync(2);
        Assert.That(header[1], Is.LessThan(126), "short frames are enough here");
        return (header[0] & 0x0F, await ReadAsync(header[1]));
    }

    /// <summary>Waits until the gateway has closed the connection. Ignores all data received before.</summary>
    public Task ExpectEndAsync() => CopyToEndAsync(Stream.Null);

    /// <summary>Returns all data that the gateway sends until it closes the connection.</summary>
    public async Task<string> ReadToEndAsync()
    {
        using var received = new MemoryStream();
        await CopyToEndAsync(received);
        return Encoding.UTF8.GetString(received.ToArray());
    }

    async Task CopyToEndAsync(Stream received)
    {
        try
        {
            await _stream.CopyToAsync(received).Bounded();
        }
        catch (IOException)
        {
            // The gateway closed the connection before it had read all bytes, which resets the connection.
        }
    }

    public void Dispose()
    {
        _stream?.Dispose();
        _tcp.Dispose();
    }

    public Task SendAsync(byte[] bytes) => _stream.WriteAsync(bytes).AsTask().Bounded();

    async Task<byte[]> ReadAsync(int count)
    {
        var bytes = new byte[count];
        await _stream.ReadExactlyAsync(bytes).AsTask().Bounded();
        return bytes;
    }
}
