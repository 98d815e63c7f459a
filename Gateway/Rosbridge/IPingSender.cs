namespace Nowpose.Gateway.Rosbridge;

/// <summary>Sends pings of a WebSocket between its messages. A payload has at most 125 bytes.</summary>
interface IPingSender
{
    /// <summary>Sends a ping at once, after everything that was sent before.</summary>
    Task SendAsync(ReadOnlyMemory<byte> payload);

    /// <summary>Sends a ping together with the next frame, and before it.</summary>
    void SendWithNext(ReadOnlyMemory<byte> payload);
}
