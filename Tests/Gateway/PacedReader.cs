using System.Buffers.Binary;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Subscribes to joint states, reads a limited number of bytes at a time, and answers each ping when it has read the ping.</summary>
sealed class PacedReader : IDisposable
{
    const int Header = 2, LongHeader = 4;
    const byte LongLength = 126;

    readonly RawWebSocket _socket;
    readonly byte[] _buffer = new byte[64 * 1024];
    int _length;

    PacedReader(RawWebSocket socket) => _socket = socket;

    /// <summary>Time stamp of the newest joint state that was read.</summary>
    public ControlTime Newest { get; private set; }

    /// <summary>Number of joint states that were read.</summary>
    public int Samples { get; private set; }

    /// <summary>Largest age of a joint state when it was read, measured from its time stamp.</summary>
    public TimeSpan MaxAge { get; private set; }

    public int Pongs { get; private set; }

    /// <param name="receiveBytes">Size of the socket's receive buffer; 0 keeps the default of the system.</param>
    public static async Task<PacedReader> OpenAsync(GatewayServer gateway, int receiveBytes = 0)
    {
        var reader = new PacedReader(await RawWebSocket.OpenAsync(gateway, receiveBytes: receiveBytes));
        await reader._socket.SendFrameAsync(RawWebSocket.Text, Encoding.UTF8.GetBytes(RosbridgeWriter.Subscribe(RosTopics.JointStates)));
        // When the gateway has responded to this call, the subscription is active.
        await reader._socket.SendFrameAsync(RawWebSocket.Text, Encoding.UTF8.GetBytes(RosbridgeWriter.CallService(RosTopics.GetTime, "subscribed")));
        await reader._socket.Stream.ReadExactlyAsync(reader._buffer.AsMemory(0, Header)).AsTask().Bounded();
        var rest = reader._buffer[1] == LongLength ? await reader.LongLengthAsync() : reader._buffer[1];
        await reader._socket.Stream.ReadExactlyAsync(reader._buffer.AsMemory(0, rest)).AsTask().Bounded();
        return reader;
    }

    /// <summary>Reads at most this number of received bytes.</summary>
    /// <param name="now">Control time at which the bytes are read.</param>
    public async Task ReadAsync(int bytes, ControlTime now)
    {
        var count = Math.Min(Math.Min(bytes, _socket.Available), _buffer.Length - _length);
        if (count == 0) return;
        _length += await _socket.Stream.ReadAsync(_buffer.AsMemory(_length, count));
        while (TakeFrame() is { } frame) await HandleAsync(frame.Opcode, frame.Payload, now);
    }

    public void Dispose() => _socket.Dispose();

    async Task<int> LongLengthAsync()
    {
        await _socket.Stream.ReadExactlyAsync(_buffer.AsMemory(0, LongHeader - Header)).AsTask().Bounded();
        return BinaryPrimitives.ReadUInt16BigEndian(_buffer);
    }

    (int Opcode, byte[] Payload)? TakeFrame()
    {
        var head = _length >= Header && _buffer[1] == LongLength ? LongHeader : Header;
        if (_length < head) return null;
        var end = head + (head == LongHeader ? BinaryPrimitives.ReadUInt16BigEndian(_buffer.AsSpan(Header)) : _buffer[1]);
        if (_length < end) return null;
        var frame = (_buffer[0] & 0x0F, _buffer[head..end]);
        _buffer.AsSpan(end, _length - end).CopyTo(_buffer);
        _length -= end;
        return frame;
    }

    async Task HandleAsync(int opcode, byte[] payload, ControlTime now)
    {
        if (opcode == RawWebSocket.Ping)
        {
            await _socket.SendFrameAsync(RawWebSocket.Pong, payload);
            Pongs++;
            return;
        }

        var text = Encoding.UTF8.GetString(payload);
        Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, $"{reason}: {text}");
        Newest = message.JointState.Stamp;
        Samples++;
        if (now - Newest > MaxAge) MaxAge = now - Newest;
    }
}
