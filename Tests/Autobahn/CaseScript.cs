using System.Buffers.Binary;
using System.Text;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>Builds the bytes that a case sends, and the payloads that it expects in return.</summary>
/// <param name="isMasked">
/// Whether frames have a mask, as the frames of a client do. The mask is zero, so payloads do not change (RFC 6455, 5.3).
/// </param>
/// <param name="before">JSON of an accepted message before the inner string.</param>
/// <param name="after">JSON of an accepted message after the inner string.</param>
sealed class CaseScript(bool isMasked, string before, string after)
{
    public const int Continuation = 0, Text = 1, Binary = 2, CloseFrame = 8, Ping = 9, Pong = 10;

    /// <summary>Byte sequences to send. Each of them is written to the socket in one call.</summary>
    public List<byte[]> Chunks { get; } = [];

    /// <summary>Inner strings of the sent messages.</summary>
    public HashSet<string> Inner { get; } = [];

    public HashSet<string> PingPayloads { get; } = [];

    /// <summary>Size of the pieces into which frames are split, in bytes; 0 to send complete frames.</summary>
    public int Chop { get; set; }

    /// <summary>Creates an accepted message in UTF-8, padded with spaces.</summary>
    public byte[] Message(string inner = "hello", int length = 0) => Message(Encoding.UTF8.GetBytes(inner), length);

    public byte[] Message(byte[] inner, int length = 0)
    {
        Inner.Add(Encoding.UTF8.GetString(inner));
        byte[] whole = [.. Encoding.UTF8.GetBytes(before), .. inner, .. Encoding.UTF8.GetBytes(after)];
        return whole.Length < length ? [.. whole, .. Enumerable.Repeat((byte)' ', length - whole.Length)] : whole;
    }

    public void Send(string inner = "hello", int length = 0) => Frame(Text, Message(inner, length));

    /// <summary>Sends a message in the given number of frames; 0 for one frame per byte.</summary>
    public void SendFragments(byte[] message, int fragments, Action between = null)
    {
        var size = fragments == 0 ? 1 : (message.Length + fragments - 1) / fragments;
        for (var at = 0; at < message.Length; at += size)
        {
            var end = Math.Min(message.Length, at + size);
            Frame(at == 0 ? Text : Continuation, message[at..end], end == message.Length);
            if (end < message.Length) between?.Invoke();
        }
    }

    public void SendPing(string payload = "")
    {
        PingPayloads.Add(payload);
        Frame(Ping, Encoding.UTF8.GetBytes(payload));
    }

    public void SendClose(int code, byte[] reason = null) => Frame(CloseFrame, [(byte)(code >> 8), (byte)code, .. reason ?? []]);

    public void Frame(int opcode, byte[] payload = null, bool isFinal = true, int reserved = 0)
    {
        payload ??= [];
        byte[] length = payload.Length switch { < 126 => [(byte)payload.Length], < 65536 => [126, 0, 0], _ => [127, 0, 0, 0, 0, 0, 0, 0, 0] };
        if (length.Length == 3) BinaryPrimitives.WriteUInt16BigEndian(length.AsSpan(1), (ushort)payload.Length);
        if (length.Length == 9) BinaryPrimitives.WriteUInt64BigEndian(length.AsSpan(1), (ulong)payload.Length);
        if (isMasked) length[0] |= 0x80;
        Add([(byte)((isFinal ? 0x80 : 0) | reserved << 4 | opcode), .. length, .. isMasked ? new byte[4] : [], .. payload]);
    }

    void Add(byte[] frame)
    {
        if (Chop == 0) Chunks.Add(frame);
        else Chunks.AddRange(frame.Chunk(Chop));
    }
}
