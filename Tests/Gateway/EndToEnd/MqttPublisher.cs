using System.Net.Sockets;
using System.Text;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>Publishes messages with a minimal implementation of MQTT 3.1.1, independent of the adapter.</summary>
sealed class MqttPublisher : IDisposable
{
    const byte Connect = 0x10, Publish = 0x30, AtLeastOnce = 0x02, Retain = 0x01;
    const byte Version = 4, CleanSession = 0x02, MoreLength = 0x80;
    const int AnswerBytes = 4;

    readonly TcpClient _client = new();
    ushort _packet;

    /// <summary>Connects to a broker on this machine.</summary>
    public static async Task<MqttPublisher> ConnectAsync(int port)
    {
        var publisher = new MqttPublisher();
        await publisher._client.ConnectAsync("127.0.0.1", port).Bounded();
        await publisher.SendAsync(Connect, [.. Text("MQTT"), Version, CleanSession, 0, 0, .. Text("plc")]);
        return publisher;
    }

    /// <summary>Publishes a message and waits for the broker's acknowledgement.</summary>
    /// <param name="isRetained">Whether the broker also sends the message to later subscribers.</param>
    public Task PublishAsync(string topic, string message, bool isRetained = false)
    {
        _packet++;
        return SendAsync(
            (byte)(Publish | AtLeastOnce | (isRetained ? Retain : 0)), [.. Text(topic), (byte)(_packet >> 8), (byte)_packet, .. Encoding.UTF8.GetBytes(message)]);
    }

    public void Dispose() => _client.Dispose();

    // Sends a packet and reads the response, which has four bytes for all kinds of packets.
    async Task SendAsync(byte kind, byte[] content)
    {
        var length = content.Length < MoreLength
            ? new[] { (byte)content.Length } : [(byte)(content.Length % MoreLength | MoreLength), (byte)(content.Length / MoreLength)];
        await _client.GetStream().WriteAsync((byte[])[kind, .. length, .. content]).AsTask().Bounded();
        await _client.GetStream().ReadExactlyAsync(new byte[AnswerBytes]).AsTask().Bounded();
    }

    static byte[] Text(string text) => [(byte)(text.Length >> 8), (byte)text.Length, .. Encoding.UTF8.GetBytes(text)];
}
