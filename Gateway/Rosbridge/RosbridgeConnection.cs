using System.Net.WebSockets;
using System.Threading.Channels;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>One client's WebSocket: reads messages one by one, sends whatever its session and subscriptions have.</summary>
sealed class RosbridgeConnection : IDisposable
{
    const int WaitingReplies = 64;
    static readonly TimeSpan GoodbyeTimeout = TimeSpan.FromSeconds(1);

    readonly WebSocket _socket;
    readonly MessageReceiver _receiver;
    readonly SemaphoreSlim _sending = new(1);
    readonly CancellationToken _serverStops;
    readonly CancellationTokenSource _stop = new();
    readonly Channel<ReadOnlyMemory<byte>> _replies =
        Channel.CreateBounded<ReadOnlyMemory<byte>>(new BoundedChannelOptions(WaitingReplies) { FullMode = BoundedChannelFullMode.DropOldest });
    readonly List<Task> _pumps = [];

    public RosbridgeConnection(WebSocket socket, MessageReceiver receiver, CancellationToken serverStops)
    {
        _socket = socket;
        _receiver = receiver;
        _serverStops = serverStops;
    }

    /// <summary>Who sends, or did not long ago.</summary>
    internal int Pumps => _pumps.Count;

    /// <summary>Sends when there is room; a client that reads nothing loses the oldest replies.</summary>
    public void Reply(ReadOnlyMemory<byte> message) => _replies.Writer.TryWrite(message);

    /// <summary>Sends what a subscription gets. From the thread that handles the messages.</summary>
    public void Start(Subscription subscription)
    {
        // A client may change its subscriptions as long as it is connected. One that failed is waited for, and tells.
        _pumps.RemoveAll(pump => pump.IsCompletedSuccessfully);
        _pumps.Add(PumpAsync(() => subscription.PumpAsync(SendAsync, _stop.Token)));
    }

    /// <summary>Serves until either side ends it; says why it ended.</summary>
    public async Task<Closure> RunAsync(RosbridgeSession session)
    {
        _pumps.Add(PumpAsync(RepliesAsync));
        Closure why;
        // The client answers with its own close, which ends the receiving; or it does not, and time is up.
        await using (_serverStops.UnsafeRegister(_ => _ = SayGoodbyeAsync(Closure.Stopped), null))
            why = await ReceiveAsync(session);
        session.Dispose();
        if (why is not (Closure.Stopped or Closure.Silence))
            await SayGoodbyeAsync(why);
        await _stop.CancelAsync();
        _socket.Abort();
        await Task.WhenAll(_pumps);
        return why;
    }

    public void Dispose()
    {
        _stop.Dispose();
        _sending.Dispose();
    }

    async Task<Closure> ReceiveAsync(RosbridgeSession session)
    {
        try
        {
            while (true)
            {
                var received = await _receiver.NextAsync();
                if (received.End is { } why)
                    return _serverStops.IsCancellationRequested ? Closure.Stopped : why;
                session.Handle(received);
            }
        }
        catch (Exception e) when (IsEndOfConnection(e))
        {
            if (_serverStops.IsCancellationRequested)
                return Closure.Stopped;
            return Explain(e);
        }
    }

    Closure Explain(Exception e) => (e as WebSocketException)?.WebSocketErrorCode switch
    {
        // Frames and texts against RFC 6455, which the socket itself answers with a close of 1002 or 1007.
        WebSocketError.Faulted or WebSocketError.InvalidMessageType => Closure.MalformedFrame,
        WebSocketError.ConnectionClosedPrematurely => Closure.ByPeer,
        // The keep-alive that had no pong aborts the socket.
        _ => _socket.State == WebSocketState.Aborted ? Closure.Silence : Closure.ByPeer,
    };

    async Task RepliesAsync()
    {
        await foreach (var reply in _replies.Reader.ReadAllAsync(_stop.Token))
            await SendAsync(reply);
    }

    async Task SendAsync(ReadOnlyMemory<byte> message)
    {
        await _sending.WaitAsync(_stop.Token);
        try
        {
            await _socket.SendAsync(message, WebSocketMessageType.Text, true, CancellationToken.None);
        }
        finally
        {
            _sending.Release();
        }
    }

    static async Task PumpAsync(Func<Task> pump)
    {
        try
        {
            await pump();
        }
        catch (Exception e) when (IsEndOfConnection(e))
        {
            // The receiving side ends the connection.
        }
    }

    async Task SayGoodbyeAsync(Closure why)
    {
        using var patience = new CancellationTokenSource(GoodbyeTimeout);
        try
        {
            await _socket.CloseOutputAsync(StatusOf(why), why.ToString(), patience.Token);
            if (why == Closure.Stopped)
                await Task.Delay(GoodbyeTimeout, _stop.Token);
            else if (why != Closure.ByPeer)
                await _receiver.DrainAsync(GoodbyeTimeout);
        }
        catch (Exception e) when (IsEndOfConnection(e) || e is InvalidOperationException)
        {
            // Already gone.
        }

        if (why == Closure.Stopped)
            _socket.Abort();
    }

    static WebSocketCloseStatus StatusOf(Closure why) => why switch
    {
        Closure.ByPeer => WebSocketCloseStatus.NormalClosure,
        Closure.Stopped => WebSocketCloseStatus.EndpointUnavailable,
        Closure.EndlessMessage => WebSocketCloseStatus.MessageTooBig,
        _ => WebSocketCloseStatus.PolicyViolation,
    };

    static bool IsEndOfConnection(Exception e) =>
        e is WebSocketException or OperationCanceledException or IOException or ObjectDisposedException;
}
