using System.Buffers.Text;

namespace Nowpose.Benchmarks.Load;

/// <summary>Reads the time stamp of rosbridge's joint states without the rest, because 200 clients share a machine with the gateway.</summary>
static class StampReader
{
    /// <summary>Gets the time stamp of a joint state, ns. Returns false for any other message.</summary>
    public static bool TryRead(ReadOnlySpan<byte> message, out long nanoseconds)
    {
        nanoseconds = 0;
        if (!TryReadNumber(message, "\"sec\":"u8, out var seconds) || !TryReadNumber(message, "\"nanosec\":"u8, out var rest)) return false;
        nanoseconds = (seconds * 1_000_000_000) + rest;
        return true;
    }

    static bool TryReadNumber(ReadOnlySpan<byte> message, ReadOnlySpan<byte> key, out long number)
    {
        number = 0;
        var at = message.IndexOf(key);
        return at >= 0 && Utf8Parser.TryParse(message[(at + key.Length)..], out number, out _);
    }
}
