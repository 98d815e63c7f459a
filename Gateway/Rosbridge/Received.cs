namespace Nowpose.Gateway.Rosbridge;

/// <summary>The result of receiving from a WebSocket.</summary>
/// <param name="Utf8">The message, valid until the next receive; empty for a dropped message and at the end of the connection.</param>
/// <param name="Fault">The reason why the message was dropped.</param>
/// <param name="End">The reason why the connection ended; null while it is open.</param>
/// <param name="Count">Time at which the last byte of the message was read, a timestamp of the hub's time provider.</param>
readonly record struct Received(ReadOnlyMemory<byte> Utf8, DropReason Fault, Closure? End, long Count = 0)
{
    public static Received Ended(Closure why) => new(default, DropReason.None, why);
}
