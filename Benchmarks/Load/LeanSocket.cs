using System.Net;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;

namespace Nowpose.Benchmarks.Load;

/// <summary>Opens WebSocket connections that send nothing of their own, except replies to pings.</summary>
static class LeanSocket
{
    /// <param name="receiveBytes">Size of the operating system's receive buffer; 0 for the default.</param>
    public static async Task<WebSocket> OpenAsync(IPEndPoint server, int receiveBytes = 0)
    {
        var client = new ClientWebSocket { Options = { KeepAliveInterval = TimeSpan.Zero } };
        try
        {
            using var http = new HttpMessageInvoker(new SocketsHttpHandler
            {
                UseProxy = false,
                ConnectCallback = async (_, stop) => new NetworkStream(await ConnectAsync(server, receiveBytes, stop), ownsSocket: true),
            });
            await client.ConnectAsync(new Uri($"ws://{server}/"), http, CancellationToken.None);
            return client;
        }
        catch
        {
            client.Dispose();
            throw;
        }
    }

    public static Task SendTextAsync(WebSocket socket, string text) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, endOfMessage: true, CancellationToken.None);

    static async Task<Socket> ConnectAsync(IPEndPoint server, int receiveBytes, CancellationToken stop)
    {
        var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp) { NoDelay = true };
        if (receiveBytes > 0) socket.ReceiveBufferSize = receiveBytes;
        try
        {
            await socket.ConnectAsync(server, stop);
            return socket;
        }
        catch
        {
            socket.Dispose();
            throw;
        }
    }
}
