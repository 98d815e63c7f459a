using System.Buffers.Binary;
using System.Buffers.Text;

namespace Nowpose.Benchmarks.Load;

/// <summary>
/// Reads WebSocket frames (RFC 6455) and the time stamps of rosbridge's joint states. Uses little processor time, because 200 clients share a
/// machine with the gateway.
/// </summary>
sealed class FrameReader
{
    public const int Text = 1, Close = 8, Ping = 9;

    readonly byte[] _buffer = new byte[32 * 1024];
    int _length;

    public Memory<byte> Room => _buffer.AsMemory(_length);

    public void Added(int bytes) => _length += bytes;

    /// <summary>Gets the next complete frame, if there is one. The payload is valid until the next <see cref="Discard"/>.</summary>
    public bool TryTake(ref int at, out int opcode, out ReadOnlySpan<byte> payload)
    {
        opcode = 0;
        payload = default;
        var bytes = _buffer.AsSpan(at, _length - at);
        if (bytes.Length < 2) return false;
        var (head, length) = bytes[1] switch
        {
            126 => (4, bytes.Length < 4 ? int.MaxValue : BinaryPrimitives.ReadUInt16BigEndian(bytes[2..])),
            127 => throw new InputException("the gateway sent a frame that is too long for a joint state"),
            var small => (2, small),
        };
        if (length > bytes.Length - head) return false;
        opcode = bytes[0] & 0x0F;
        payload = bytes.Slice(head, length);
        at += head + length;
        return true;
    }

    /// <summary>Releases the space of the frames that have been read.</summary>
    public void Discard(int at)
    {
        _buffer.AsSpan(at, _length - at).CopyTo(_buffer);
        _length -= at;
    }

    /// <summary>Gets the time stamp of a joint state, ns. Returns false for any other message.</summary>
    public static bool TryReadStamp(ReadOnlySpan<byte> message, out long nanoseconds)
    {
        nanoseconds = 0;
        if (!TryReadNumber(message, "\"sec\":"u8, out var seconds) || !TryReadNumber(message, "\"nanosec\":"u8, out var rest)) return false;
        nanoseconds = (seconds * 1_000_000_000) + rest;
        return true;
    }

    /// <summary>Creates a frame as a client sends it. The mask of zeros leaves the bytes unchanged.</summary>
    public static byte[] Frame(int opcode, ReadOnlySpan<byte> payload)
    {
        var isShort = payload.Length < 126;
        var frame = new byte[payload.Length + (isShort ? 6 : 8)];
        frame[0] = (byte)(0x80 | opcode);
        frame[1] = (byte)(0x80 | (isShort ? payload.Length : 126));
        if (!isShort) BinaryPrimitives.WriteUInt16BigEndian(frame.AsSpan(2), checked((ushort)payload.Length));
        payload.CopyTo(frame.AsSpan(frame.Length - payload.Length));
        return frame;
    }

    static bool TryReadNumber(ReadOnlySpan<byte> message, ReadOnlySpan<byte> key, out long number)
    {
        number = 0;
        var at = message.IndexOf(key);
        return at >= 0 && Utf8Parser.TryParse(message[(at + key.Length)..], out number, out _);
    }
}
