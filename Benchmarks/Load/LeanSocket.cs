using System.Net;
using System.Net.Sockets;
using System.Text;

namespace Nowpose.Benchmarks.Load;

/// <summary>A minimal WebSocket client: a TCP socket after the HTTP upgrade.</summary>
static class LeanSocket
{
    const int Pong = 10;

    /// <param name="receiveBytes">Size of the operating system's receive buffer; 0 for the default.</param>
    public static async Task<Socket> OpenAsync(IPEndPoint server, int receiveBytes = 0)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        try
        {
            if (receiveBytes > 0) socket.ReceiveBufferSize = receiveBytes;
            await socket.ConnectAsync(server);
            await socket.SendAsync(Encoding.ASCII.GetBytes(
                $"GET / HTTP/1.1\r\nHost: {server}\r\nConnection: Upgrade\r\nUpgrade: websocket\r\n"
                + "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n"));
            await ReadHeadAsync(socket);
            return socket;
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }

    public static Task<int> SendTextAsync(Socket socket, string text) =>
        socket.SendAsync(FrameReader.Frame(FrameReader.Text, Encoding.UTF8.GetBytes(text)));

    public static Task<int> SendPongAsync(Socket socket, ReadOnlySpan<byte> payload) =>
        socket.SendAsync(FrameReader.Frame(Pong, payload));

    static async Task ReadHeadAsync(Socket socket)
    {
        var head = new StringBuilder();
        var one = new byte[1];
        while (!head.ToString().EndsWith("\r\n\r\n", StringComparison.Ordinal))
        {
            if (await socket.ReceiveAsync(one) == 0) throw new IOException("the gateway closed the connection");
            head.Append((char)one[0]);
        }

        var line = head.ToString().Split('\r')[0];
        if (!line.Contains(" 101 ", StringComparison.Ordinal)) throw new IOException($"the gateway refused the WebSocket: {line}");
    }
}
