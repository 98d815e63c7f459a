using System.Net.WebSockets;
using System.Threading.Channels;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>One client's WebSocket: reads messages one by one, sends whatever its session and subscriptions have.</summary>
sealed class RosbridgeConnection : IDisposable
{
    internal const int WaitingReplies = 64;
    const int NotEnded = -1;
    static readonly TimeSpan GoodbyeTimeout = ProtocolLimits.GoodbyeTimeout;

    readonly WebSocket _socket;
    readonly MessageReceiver _receiver;
    readonly SemaphoreSlim _sending = new(1);
    readonly ReaderProgress _reader;
    readonly CancellationToken _serverStops;
    readonly CancellationTokenSource _stop = new();
    readonly Channel<ReadOnlyMemory<byte>> _replies;
    readonly Dictionary<string, TopicPump> _pumps = [];
    int _ended = NotEnded;

    /// <param name="reader">How far the peer has read, and how long it may take.</param>
    public RosbridgeConnection(
        WebSocket socket, MessageReceiver receiver, ReaderProgress reader, DropCounters drops, CancellationToken serverStops)
    {
        _socket = socket;
        _receiver = receiver;
        _reader = reader;
        _serverStops = serverStops;
        _replies = Channel.CreateBounded<ReadOnlyMemory<byte>>(
            new BoundedChannelOptions(WaitingReplies) { FullMode = BoundedChannelFullMode.DropOldest }, _ => drops.Count(DropReason.SlowReader));
    }

    /// <summary>Who sends, or did not long ago: no more than one for a topic.</summary>
    internal int Pumps => _pumps.Count;

    /// <summary>Sends when there is room; a client that reads nothing loses the oldest replies.</summary>
    public void Reply(ReadOnlyMemory<byte> message) => _replies.Writer.TryWrite(message);

    /// <summary>Sends what a subscription gets. From the thread that handles the messages.</summary>
    public void Start(Subscription subscription)
    {
        // A client may name other topics as long as it is connected. One that failed is waited for, and tells.
        foreach (var (topic, pump) in _pumps)
            if (pump.Ended.IsCompletedSuccessfully) _pumps.Remove(topic);
        if (!_pumps.TryGetValue(subscription.Topic, out var own))
            _pumps.Add(subscription.Topic, own = new TopicPump(one => PumpAsync(() => one.PumpAsync(SendAsync, _stop.Token))));
        own.Start(subscription);
    }

    /// <summary>Says goodbye, and listens to nothing more. Any thread; waits for nobody.</summary>
    public void End(Closure why)
    {
        if (Interlocked.CompareExchange(ref _ended, (int)why, NotEnded) == NotEnded)
            _ = SayGoodbyeAsync(why);
    }

    /// <summary>Serves until either side ends it; says why it ended.</summary>
    public async Task<Closure> RunAsync(RosbridgeSession session)
    {
        var replying = PumpAsync(RepliesAsync);
        var watching = PumpAsync(EndWhenSilentAsync);
        Closure why;
        // The client answers with its own close, which ends the receiving; or it does not, and time is up.
        await using (_serverStops.UnsafeRegister(_ => End(Closure.Stopped), null))
            why = await ReceiveAsync(session);
        if (Ended == null && HasPeerLeft) session.Leave();
        session.Dispose();
        if (Ended == null && why != Closure.Silence)
            await SayGoodbyeAsync(why);
        await _stop.CancelAsync();
        await StopPumpsAsync(Task.WhenAll(replying, watching), isGone: why == Closure.Silence);
        return why;
    }

    public void Dispose()
    {
        _stop.Dispose();
        _sending.Dispose();
    }

    // What this side decided, if it did.
    Closure? Ended => Volatile.Read(ref _ended) is var ended && ended != NotEnded ? (Closure)ended : null;

    // A close with another code reports a fault of the peer.
    bool HasPeerLeft => _socket.CloseStatus
        is WebSocketCloseStatus.NormalClosure or WebSocketCloseStatus.EndpointUnavailable or WebSocketCloseStatus.Empty;

    async Task<Closure> ReceiveAsync(RosbridgeSession session)
    {
        try
        {
            while (true)
            {
                var received = await _receiver.NextAsync();
                if (received.End is { } why)
                    return Ended ?? why;
                if (Ended == null) session.Handle(received);
            }
        }
        catch (Exception e) when (IsEndOfConnection(e))
        {
            return Ended ?? Explain(e);
        }
    }

    static Closure Explain(Exception e) => (e as WebSocketException)?.WebSocketErrorCode switch
    {
        // Frames and texts against RFC 6455, which the socket itself answers with a close of 1002 or 1007.
        WebSocketError.Faulted or WebSocketError.InvalidMessageType => Closure.MalformedFrame,
        WebSocketError.ConnectionClosedPrematurely => Closure.ByPeer,
        _ => Closure.ByPeer,
    };

    async Task RepliesAsync()
    {
        while (await _replies.Reader.WaitToReadAsync(_stop.Token))
            await SendAsync(_ => _replies.Reader.TryRead(out var reply) ? reply : default);
    }

    // The message is chosen when there is room for it: one that was chosen before would be old by then.
    async Task SendAsync(Func<long, ReadOnlyMemory<byte>> next)
    {
        await _sending.WaitAsync(_stop.Token);
        try
        {
            await _reader.OpensAsync(_stop.Token);
            var message = next(_reader.WaitedUntil);
            if (message.IsEmpty) return;
            await _reader.SendsAsync(message.Length);
            var sending = _socket.SendAsync(message, WebSocketMessageType.Text, true, CancellationToken.None);
            if (sending.IsCompleted)
                await sending;
            else
                await BecomesSentAsync(sending.AsTask(), message.Length);
            _reader.OnSent(message.Length);
        }
        finally
        {
            _sending.Release();
        }
    }

    // No goodbye would get past what it does not read.
    async Task EndWhenSilentAsync()
    {
        await _reader.BecomesSilentAsync(_stop.Token);
        Interlocked.CompareExchange(ref _ended, (int)Closure.Silence, NotEnded);
        _socket.Abort();
    }

    // Whatever comes from a peer counts for the pong that does not: one that sends and reads nothing would stay for ever.
    async Task BecomesSentAsync(Task sending, int length)
    {
        try
        {
            await sending.WaitAsync(_reader.Patience(length));
            _reader.OnWaited();
        }
        catch (TimeoutException)
        {
            // No goodbye either would get past what it does not read.
            Interlocked.CompareExchange(ref _ended, (int)Closure.Silence, NotEnded);
            _socket.Abort();
            await sending;
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

    // Aborting throws away what is still on its way out, the close with its code among it: only for a peer that takes nothing.
    async Task StopPumpsAsync(Task replying, bool isGone)
    {
        var pumps = Task.WhenAll([replying, .. _pumps.Values.Select(pump => pump.Ended)]);
        if (isGone || await Task.WhenAny(pumps, Task.Delay(GoodbyeTimeout)) != pumps)
            _socket.Abort();
        await pumps;
    }

    async Task SayGoodbyeAsync(Closure why)
    {
        using var patience = new CancellationTokenSource(GoodbyeTimeout);
        try
        {
            // A peer's close is answered with its own code, or with none where it gave none.
            if (why == Closure.ByPeer)
                await _socket.CloseOutputAsync(_socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure, null, patience.Token);
            else
                await _socket.CloseOutputAsync(StatusOf(why), why.ToString(), patience.Token);
            if (Ended != null)
                await Task.Delay(GoodbyeTimeout, _stop.Token);
            else if (why != Closure.ByPeer)
                await _receiver.DrainAsync(GoodbyeTimeout);
        }
        catch (Exception e) when (IsEndOfConnection(e) || e is InvalidOperationException)
        {
            // Already gone.
        }

        if (Ended != null)
            _socket.Abort();
    }

    static WebSocketCloseStatus StatusOf(Closure why) => why switch
    {
        Closure.Stopped => WebSocketCloseStatus.EndpointUnavailable,
        Closure.EndlessMessage => WebSocketCloseStatus.MessageTooBig,
        _ => WebSocketCloseStatus.PolicyViolation,
    };

    static bool IsEndOfConnection(Exception e) =>
        e is WebSocketException or OperationCanceledException or IOException or ObjectDisposedException;
}
