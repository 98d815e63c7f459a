using System.Net.WebSockets;
using System.Text;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Returns the given pieces of text messages, one for each call of receive. Before each piece it runs the action of the piece.</summary>
sealed class ScriptedWebSocket(params (string Text, bool IsEnd, Action Meanwhile)[] pieces) : WebSocket
{
    int _next;

    public override WebSocketCloseStatus? CloseStatus => null;
    public override string CloseStatusDescription => null;
    public override WebSocketState State => WebSocketState.Open;
    public override string SubProtocol => null;

    public override Task<WebSocketReceiveResult> ReceiveAsync(ArraySegment<byte> buffer, CancellationToken cancellationToken)
    {
        var (text, isEnd, meanwhile) = pieces[_next++];
        meanwhile();
        var count = Encoding.UTF8.GetBytes(text, buffer);
        return Task.FromResult(new WebSocketReceiveResult(count, WebSocketMessageType.Text, isEnd));
    }

    public override Task SendAsync(
        ArraySegment<byte> buffer, WebSocketMessageType messageType, bool endOfMessage, CancellationToken cancellationToken) =>
        Task.CompletedTask;

    public override Task CloseAsync(WebSocketCloseStatus closeStatus, string statusDescription, CancellationToken cancellationToken) =>
        Task.CompletedTask;

    public override Task CloseOutputAsync(
        WebSocketCloseStatus closeStatus, string statusDescription, CancellationToken cancellationToken) =>
        Task.CompletedTask;

    public override void Abort()
    {
    }

    public override void Dispose()
    {
    }
}
