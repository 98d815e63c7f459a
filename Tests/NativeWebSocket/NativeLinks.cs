using System.Net.WebSockets;
using System.Text;
using Nowpose.Network;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests;

/// <summary>Opens links over NativeWebSocket, and returns their messages and failures.</summary>
static class NativeLinks
{
    public static readonly StopwatchHeadsetClock Clock = new();

    public sealed record Message(string Text, DropReason Dropped, HeadsetTime Arrival);

    public static NativeWebSocketLink Link(int port, string token = null, IHeadsetClock clock = null) =>
        new(new ConnectionSettings("127.0.0.1", webSocketPort: port, token: token), clock ?? Clock);

    public static async Task<(NativeWebSocketLink Link, WebSocket Server)> OpenAsync(FakeWebSocketServer server, IHeadsetClock clock = null)
    {
        var link = Link(server.Port, clock: clock);
        var opening = link.OpenAsync(default);
        var socket = await server.AcceptAsync();
        await opening.Bounded();
        return (link, socket);
    }

    public static Task Send(WebSocket socket, string text, bool end = true) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(text), WebSocketMessageType.Text, end, CancellationToken.None);

    /// <summary>Returns the next message; null at the end.</summary>
    public static async Task<Message> NextAsync(NativeWebSocketLink link, CancellationToken cancel = default)
    {
        using var stop = CancellationTokenSource.CreateLinkedTokenSource(cancel);
        Message next = null;
        try
        {
            await link.ReceiveAsync(received =>
            {
                var text = received.Dropped == DropReason.None ? Encoding.UTF8.GetString(received.Utf8.Span) : null;
                next = new Message(text, received.Dropped, received.Arrival);
                stop.Cancel();
            }, stop.Token).Bounded();
        }
        catch (OperationCanceledException) when (next != null)
        {
            // Only the first message is needed.
        }
        return next;
    }

    public static async Task<Exception> FailureOf(Task task)
    {
        try
        {
            await task.Bounded();
            return null;
        }
        catch (Exception failure) when (failure is not TimeoutException)
        {
            return failure;
        }
    }
}
