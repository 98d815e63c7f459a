using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>What came next on a WebSocket.</summary>
/// <param name="Utf8">The message, until the next is received; empty when it was dropped and at the end.</param>
/// <param name="Fault">Why it was dropped.</param>
/// <param name="End">Why nothing follows; null while something may.</param>
/// <param name="Count">When its last byte had been read, in counts of <see cref="System.Diagnostics.Stopwatch"/>.</param>
readonly record struct Received(ReadOnlyMemory<byte> Utf8, DropReason Fault, Closure? End, long Count = 0)
{
    public static Received Ended(Closure why) => new(default, DropReason.None, why);
}
