using System.Collections.Concurrent;
using System.Net.WebSockets;
using System.Text;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Accepts messages to send, but completes no send before the test calls <see cref="GoOn"/>. It receives no messages.</summary>
sealed class StuckWebSocket : WebSocket
{
    readonly TaskCompletionSource _goOn = new(TaskCreationOptions.RunContinuationsAsynchronously);
    readonly ConcurrentQueue<string> _sent = [];

    int _messages;

    /// <summary>Number of fragments to send.</summary>
    public int Sends => _sent.Count;

    /// <summary>Number of messages whose last fragment is among them.</summary>
    public int Messages => Volatile.Read(ref _messages);

    /// <summary>The fragments to send. Most messages have one.</summary>
    public IEnumerable<string> Sent => _sent;

    public override WebSocketCloseStatus? CloseStatus => null;
    public override string CloseStatusDescription => null;
    public override WebSocketState State => WebSocketState.Open;
    public override string SubProtocol => null;

    public void GoOn() => _goOn.TrySetResult();

    public override Task SendAsync(
        ArraySegment<byte> buffer, WebSocketMessageType messageType, bool endOfMessage, CancellationToken cancellationToken)
    {
        _sent.Enqueue(Encoding.UTF8.GetString(buffer));
        if (endOfMessage) Interlocked.Increment(ref _messages);
        return _goOn.Task;
    }

    public override Task<WebSocketReceiveResult> ReceiveAsync(ArraySegment<byte> buffer, CancellationToken cancellationToken) =>
        throw new NotSupportedException();

    public override Task CloseAsync(WebSocketCloseStatus closeStatus, string statusDescription, CancellationToken cancellationToken) =>
        Task.CompletedTask;

    public override Task CloseOutputAsync(
        WebSocketCloseStatus closeStatus, string statusDescription, CancellationToken cancellationToken) =>
        Task.CompletedTask;

    public override void Abort() => GoOn();

    public override void Dispose() => GoOn();
}
