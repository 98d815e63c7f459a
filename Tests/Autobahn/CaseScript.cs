using System.Buffers.Binary;
using System.Text;

namespace Nowpose.Headless.Tests.Autobahn;

/// <summary>The bytes that a case sends, and what it expects to be given back.</summary>
/// <param name="isMasked">As a client's frames are; masked with zeros, so the payload is as it is (RFC 6455, 5.3).</param>
/// <param name="before">What stands before the inner text of a message that the other side takes.</param>
/// <param name="after">What stands behind it.</param>
sealed class CaseScript(bool isMasked, string before, string after)
{
    public const int Continuation = 0, Text = 1, Binary = 2, CloseFrame = 8, Ping = 9, Pong = 10;

    /// <summary>What is handed to the socket at once.</summary>
    public List<byte[]> Chunks { get; } = [];

    /// <summary>Inner texts of messages.</summary>
    public HashSet<string> Inner { get; } = [];

    public HashSet<string> PingPayloads { get; } = [];

    /// <summary>Into pieces of how many bytes frames are cut on their way; 0 for whole ones.</summary>
    public int Chop { get; set; }

    /// <summary>A message that is taken, as UTF-8, filled up with blanks.</summary>
    public byte[] Message(string inner = "hello", int length = 0) => Message(Encoding.UTF8.GetBytes(inner), length);

    public byte[] Message(byte[] inner, int length = 0)
    {
        Inner.Add(Encoding.UTF8.GetString(inner));
        byte[] whole = [.. Encoding.UTF8.GetBytes(before), .. inner, .. Encoding.UTF8.GetBytes(after)];
        return whole.Length < length ? [.. whole, .. Enumerable.Repeat((byte)' ', length - whole.Length)] : whole;
    }

    public void Send(string inner = "hello", int length = 0) => Frame(Text, Message(inner, length));

    /// <summary>One message in so many frames, or a frame for each byte with 0.</summary>
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
