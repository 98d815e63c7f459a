using System.Net.WebSockets;
using System.Threading.Channels;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>One client's WebSocket. Receives messages one by one and sends the data of its session and subscriptions.</summary>
sealed class RosbridgeConnection : IDisposable
{
    internal const int WaitingReplies = 64;
    const int NotEnded = -1;
    static readonly TimeSpan CloseTimeout = ProtocolLimits.CloseTimeout;

    readonly WebSocket _socket;
    readonly MessageReceiver _receiver;
    readonly SemaphoreSlim _sending = new(1);
    readonly ReaderProgress _reader;
    readonly CancellationToken _serverStops;
    readonly CancellationTokenSource _stop = new();
    readonly Channel<ReadOnlyMemory<byte>> _replies;
    readonly Dictionary<string, TopicPump> _pumps = [];
    int _ended = NotEnded;

    /// <param name="reader">Tracks how far the peer has read, and its timeout.</param>
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

    /// <summary>Number of topic pumps, including those that ended recently: at most one per topic.</summary>
    internal int Pumps => _pumps.Count;

    /// <summary>Queues a reply. If the client does not read, the oldest replies are dropped.</summary>
    public void Reply(ReadOnlyMemory<byte> message) => _replies.Writer.TryWrite(message);

    /// <summary>Starts to send the messages of a subscription. Called by the thread that handles the client's messages.</summary>
    public void Start(Subscription subscription)
    {
        // Removed because a client can use any number of topics over time. A failed pump stays, so that its exception is reported.
        foreach (var (topic, pump) in _pumps)
            if (pump.Ended.IsCompletedSuccessfully) _pumps.Remove(topic);
        if (!_pumps.TryGetValue(subscription.Topic, out var own))
            _pumps.Add(subscription.Topic, own = new TopicPump(one => PumpAsync(() => one.PumpAsync(next => SendAsync(next, isReply: false), _stop.Token))));
        own.Start(subscription);
    }

    /// <summary>Starts the close and ignores further messages. Thread-safe; does not wait.</summary>
    public void End(Closure why)
    {
        if (Interlocked.CompareExchange(ref _ended, (int)why, NotEnded) == NotEnded)
            _ = CloseAsync(why);
    }

    /// <summary>Serves the client until either side ends the connection; returns the reason.</summary>
    public async Task<Closure> RunAsync(RosbridgeSession session)
    {
        var replying = PumpAsync(RepliesAsync);
        var watching = PumpAsync(WatchAsync);
        Closure why;
        // The client answers with its own close, which ends the receiving, or the timeout ends it.
        await using (_serverStops.UnsafeRegister(_ => End(Closure.Stopped), null))
            why = await ReceiveAsync(session);
        if (Ended == null && HasPeerLeft) session.Leave();
        session.Dispose();
        if (Ended == null && why != Closure.Silence)
            await CloseAsync(why);
        await _stop.CancelAsync();
        await StopPumpsAsync(Task.WhenAll(replying, watching), isGone: why == Closure.Silence);
        return why;
    }

    public void Dispose()
    {
        _stop.Dispose();
        _sending.Dispose();
    }

    // The reason chosen by this side; null if there is none.
    Closure? Ended => Volatile.Read(ref _ended) is var ended && ended != NotEnded ? (Closure)ended : null;

    // Other close codes report a fault of the peer.
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
        // Violations of RFC 6455 in frames or texts, which the socket itself answers with a close of 1002 or 1007.
        WebSocketError.Faulted or WebSocketError.InvalidMessageType => Closure.MalformedFrame,
        WebSocketError.ConnectionClosedPrematurely => Closure.ByPeer,
        _ => Closure.ByPeer,
    };

    async Task RepliesAsync()
    {
        while (await _replies.Reader.WaitToReadAsync(_stop.Token))
            await SendAsync(_ => _replies.Reader.TryRead(out var reply) ? reply : default, isReply: true);
    }

    // Selects the message only when it can be sent, because a message selected earlier would be outdated.
    async Task SendAsync(Func<long, ReadOnlyMemory<byte>> next, bool isReply)
    {
        await _sending.WaitAsync(_stop.Token);
        try
        {
            await _reader.OpensAsync(isReply, _stop.Token);
            var message = next(_reader.WaitedUntil);
            if (message.IsEmpty) return;
            await _reader.SendsAsync(message.Length);
            var sending = _socket.SendAsync(message, WebSocketMessageType.Text, true, CancellationToken.None);
            if (sending.IsCompleted)
                await sending;
            else
                await BecomesSentAsync(sending.AsTask(), message.Length);
            _reader.OnSent(message.Length, isReply);
        }
        finally
        {
            _sending.Release();
        }
    }

    async Task WatchAsync()
    {
        if (await _reader.WatchAsync(_stop.Token) == Closure.SlowReader)
        {
            End(Closure.SlowReader);
            return;
        }

        // No close is sent: a peer that does not read would not receive it.
        Interlocked.CompareExchange(ref _ended, (int)Closure.Silence, NotEnded);
        _socket.Abort();
    }

    // Received data do not extend this timeout, unlike that of pongs: a peer that sends but never reads would stay forever.
    async Task BecomesSentAsync(Task sending, int length)
    {
        try
        {
            await sending.WaitAsync(_reader.TimeoutFor(length));
            _reader.OnWaited();
        }
        catch (TimeoutException)
        {
            // A close would not reach a peer that does not read.
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

    // Aborting discards unsent data, including the close code. It is done only for a peer that does not read.
    async Task StopPumpsAsync(Task replying, bool isGone)
    {
        var pumps = Task.WhenAll([replying, .. _pumps.Values.Select(pump => pump.Ended)]);
        if (isGone || await Task.WhenAny(pumps, Task.Delay(CloseTimeout)) != pumps)
            _socket.Abort();
        await pumps;
    }

    async Task CloseAsync(Closure why)
    {
        using var timeout = new CancellationTokenSource(CloseTimeout);
        try
        {
            // A peer's close is answered with the same code, or with none if it had none.
            if (why == Closure.ByPeer)
                await _socket.CloseOutputAsync(_socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure, null, timeout.Token);
            else
                await _socket.CloseOutputAsync(StatusOf(why), why.ToString(), timeout.Token);
            if (Ended != null)
                await Task.Delay(CloseTimeout, _stop.Token);
            else if (why != Closure.ByPeer)
                await _receiver.DrainAsync(CloseTimeout);
        }
        catch (Exception e) when (IsEndOfConnection(e) || e is InvalidOperationException)
        {
            // The connection is already closed.
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
