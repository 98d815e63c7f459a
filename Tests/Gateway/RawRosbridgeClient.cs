using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Minimal rosbridge client that sends and receives messages as text over a real socket.</summary>
sealed class RawRosbridgeClient : IDisposable
{
    readonly byte[] _buffer = new byte[2 * 1024 * 1024];

    public ClientWebSocket Socket { get; } = new();

    public static async Task<RawRosbridgeClient> ConnectAsync(GatewayServer gateway, Action<ClientWebSocketOptions> set = null)
    {
        var client = new RawRosbridgeClient();
        set?.Invoke(client.Socket.Options);
        client.Socket.Options.CollectHttpResponseDetails = true;
        if (gateway.Pin != null)
            client.Socket.Options.RemoteCertificateValidationCallback = (_, certificate, _, _) => gateway.Pin.Matches(certificate);
        await client.Socket.ConnectAsync(gateway.WebSocketUri(), default).Bounded();
        return client;
    }

    /// <summary>Connects to any address.</summary>
    public static async Task<RawRosbridgeClient> ConnectAsync(Uri uri, Action<ClientWebSocketOptions> set = null)
    {
        var client = new RawRosbridgeClient();
        set?.Invoke(client.Socket.Options);
        await client.Socket.ConnectAsync(uri, default).Bounded();
        return client;
    }

    public Task SendAsync(string text) => SendAsync(text, true);

    public Task SendAsync(string text, bool isEnd) =>
        Socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, isEnd, default).Bounded();

    public async Task<string> ReceiveTextAsync()
    {
        var length = 0;
        while (true)
        {
            var result = await Socket.ReceiveAsync(new ArraySegment<byte>(_buffer, length, _buffer.Length - length), default).Bounded();
            Assert.That(result.MessageType, Is.EqualTo(WebSocketMessageType.Text), Socket.CloseStatusDescription);
            length += result.Count;
            if (result.EndOfMessage)
                return Encoding.UTF8.GetString(_buffer, 0, length);
        }
    }

    public async Task<RosbridgeMessage> ReceiveAsync()
    {
        var text = await ReceiveTextAsync();
        Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, $"{reason}: {text}");
        return message;
    }

    /// <summary>Calls a service and waits for the response. The gateway has then handled all earlier messages of this client.</summary>
    public async Task<RosbridgeMessage> RoundTripAsync()
    {
        await SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime, "round trip"));
        var message = await ReceiveAsync();
        Assert.That(message.Id.Text, Is.EqualTo("round trip"), message.Text);
        return message;
    }

    public async Task SubscribeAsync(string topic, string type = null, int throttleMs = 0, int queue = 0)
    {
        await SendAsync(JsonSerializer.Serialize(new { op = "subscribe", topic, type, throttle_rate = throttleMs, queue_length = queue }));
        await RoundTripAsync();
    }

    /// <summary>Receives a message, which must be a status with the level error that contains <paramref name="part"/>.</summary>
    public async Task ExpectErrorAsync(string part)
    {
        var message = await ReceiveAsync();
        Assert.That(message.Op, Is.EqualTo(RosbridgeOp.Status));
        Assert.That(message.Level, Is.EqualTo("error"));
        Assert.That(message.Text, Does.Contain(part));
    }

    public void Dispose() => Socket.Dispose();
}
