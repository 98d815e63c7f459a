using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Sends and receives bytes and frames on the sync port.</summary>
sealed class RawSyncClient : IDisposable
{
    readonly TcpClient _tcp;

    RawSyncClient(IPAddress from) => _tcp = new TcpClient(new IPEndPoint(from, 0)) { NoDelay = true };

    public Stream Stream { get; set; }

    public static Task<RawSyncClient> ConnectAsync(GatewayServer gateway) => ConnectAsync(gateway.SyncEndPoint);

    public static async Task<RawSyncClient> ConnectAsync(IPEndPoint server, IPAddress from = null)
    {
        var client = new RawSyncClient(from ?? IPAddress.Any);
        await client._tcp.ConnectAsync(server).Bounded();
        client.Stream = client._tcp.GetStream();
        return client;
    }

    /// <summary>Whether the gateway accepts a token on a new connection.</summary>
    public static async Task<bool> IsAcceptedAsync(GatewayServer gateway, string token)
    {
        using var client = await ConnectAsync(gateway);
        await client.SendAsync(SyncToken.Write(token));
        return (await client.ReceiveAsync()).Value.IsAccepted;
    }

    public Task SendAsync(byte[] bytes) => Stream.WriteAsync(bytes, 0, bytes.Length).Bounded();

    public Task SendAsync(SyncFrame frame)
    {
        var bytes = new byte[SyncFrame.Size];
        frame.Write(bytes);
        return SendAsync(bytes);
    }

    /// <summary>Returns the next frame, or null if the gateway closed the connection.</summary>
    public async Task<SyncFrame?> ReceiveAsync()
    {
        var bytes = new byte[SyncFrame.Size];
        try
        {
            var read = await Stream.ReadAtLeastAsync(bytes, bytes.Length, false).AsTask().Bounded();
            return SyncFrame.TryRead(bytes.AsSpan(0, read), out var frame, out _) ? frame : null;
        }
        catch (IOException)
        {
            // The gateway closed the connection before it had read all bytes, which resets the connection.
            return null;
        }
    }

    public async Task<SyncFrame?> ExchangeAsync(SyncFrame frame)
    {
        await SendAsync(frame);
        return await ReceiveAsync();
    }

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

    /// <summary>Waits until the gateway has closed the connection. Ignores all data received before.</summary>
    public async Task ExpectEndAsync()
    {
        try
        {
            await Stream.CopyToAsync(Stream.Null).Bounded();
        }
        catch (IOException)
        {
            // The gateway closed the connection before it had read all bytes, which resets the connection.
        }
    }

    public void Dispose()
    {
        Stream?.Dispose();
        _tcp.Dispose();
    }
}
