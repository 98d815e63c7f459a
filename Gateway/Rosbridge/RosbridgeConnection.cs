using System.Net.WebSockets;
using System.Threading.Channels;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// The WebSocket connection of one client. Passes received messages to its session, and sends replies and messages of subscriptions.
/// </summary>
sealed class RosbridgeConnection : IDisposable
{
    internal const int WaitingReplies = 64;

    /// <summary>Minimum length of a fragment, in bytes. A client that reads 3 kB/s answers the ping after it within 6 s.</summary>
    internal const int MinFragmentBytes = 16 * 1024;

    /// <summary>
    /// Maximum number of fragments of a message. The gateway waits for a pong after each, and the whole message must be complete within 5 s also with a
    /// round-trip time of half a second.
    /// </summary>
    internal const int MaxFragments = 8;

    const int NotEnded = -1;
    static readonly TimeSpan CloseTimeout = ProtocolLimits.CloseTimeout;

    readonly WebSocket _socket;
    readonly MessageReceiver _receiver;
    readonly SemaphoreSlim _sending = new(1);
    readonly ReaderProgress _reader;
    readonly CancellationToken _serverStops;
    readonly CancellationTokenSource _stop = new();
    readonly Channel<ReadOnlyMemory<byte>> _replies;
    readonly Dictionary<string, SubscriptionSwitch> _switches = [];
    int _ended = NotEnded;

    /// <param name="reader">Measures how much the client has read, and detects a client that does not answer pings.</param>
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

    /// <summary>Number of topics with a subscription, including subscriptions that have ended since the last start.</summary>
    internal int Topics => _switches.Count;

    /// <summary>Queues a reply. If the client does not read, the oldest replies are dropped.</summary>
    public void Reply(ReadOnlyMemory<byte> message) => _replies.Writer.TryWrite(message);

    /// <summary>Starts to send the messages of a subscription. Called by the thread that handles the client's messages.</summary>
    public void Start(Subscription subscription)
    {
        // Removes ended topics, because a client can use any number of topics over time. Keeps a failed topic, so that its exception is reported.
        foreach (var (topic, one) in _switches)
            if (one.Ended.IsCompletedSuccessfully) _switches.Remove(topic);
        if (!_switches.TryGetValue(subscription.Topic, out var own))
            _switches.Add(subscription.Topic, own = new SubscriptionSwitch(PumpAsync));
        own.Start(subscription);
    }

    /// <summary>Starts to close the connection, and ignores further messages. Thread-safe; does not block.</summary>
    public void End(Closure why)
    {
        if (Interlocked.CompareExchange(ref _ended, (int)why, NotEnded) == NotEnded)
            _ = CloseAsync(why);
    }

    /// <summary>Serves the client until either side ends the connection.</summary>
    /// <returns>The reason why the connection ended.</returns>
    public async Task<Closure> RunAsync(RosbridgeSession session)
    {
        var replying = PumpAsync(RepliesAsync);
        var watching = PumpAsync(WatchAsync);
        Closure why;
        // When the server stops, receiving ends with the client's close frame or with the timeout.
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

    // The reason for which this side ends the connection; null if it does not.
    Closure? Ended => Volatile.Read(ref _ended) is var ended && ended != NotEnded ? (Closure)ended : null;

    // Whether the client closed the connection normally. Other close codes report a fault.
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

    // Only these two errors violate RFC 6455. For a violation, the WebSocket class itself closes with the code 1002 or 1007.
    static Closure Explain(Exception e) =>
        e is WebSocketException { WebSocketErrorCode: WebSocketError.Faulted or WebSocketError.InvalidMessageType } ? Closure.MalformedFrame : Closure.ByPeer;

    async Task RepliesAsync()
    {
        while (await _replies.Reader.WaitToReadAsync(_stop.Token))
            await SendAsync(_ => _replies.Reader.TryRead(out var reply) ? reply : default, isReply: true);
    }

    // Selects the message when the client has room for it. A message selected earlier would be outdated by then.
    async Task SendAsync(Func<long, ReadOnlyMemory<byte>> next, bool isReply)
    {
        await _sending.WaitAsync(_stop.Token);
        try
        {
            await _reader.OpensAsync(isReply, _stop.Token);
            var message = next(_reader.WaitedUntil);
            if (message.IsEmpty) return;
            await _reader.SendsAsync(message.Length);
            await SendPartsAsync(message, isReply);
        }
        finally
        {
            _sending.Release();
        }
    }

    // Sends a long message in fragments, between which the client answers pings. Its pongs show that it still reads.
    async Task SendPartsAsync(ReadOnlyMemory<byte> rest, bool isReply)
    {
        var partBytes = Math.Max(MinFragmentBytes, rest.Length / MaxFragments + 1);
        while (true)
        {
            var part = rest[..Math.Min(rest.Length, partBytes)];
            rest = rest[part.Length..];
            var sending = _socket.SendAsync(part, WebSocketMessageType.Text, rest.IsEmpty, CancellationToken.None);
            if (sending.IsCompleted)
                await sending;
            else
                await BecomesSentAsync(sending.AsTask());
            _reader.OnSent(part.Length, isReply, rest.IsEmpty);
            if (rest.IsEmpty) return;
            await _reader.OpensAsync(isReply, _stop.Token);
        }
    }

    async Task WatchAsync()
    {
        if (await _reader.WatchAsync(_stop.Token) == Closure.SlowReader)
        {
            End(Closure.SlowReader);
            return;
        }

        // Aborts without a close frame, which a client that does not read would not receive.
        Interlocked.CompareExchange(ref _ended, (int)Closure.Silence, NotEnded);
        _socket.Abort();
    }

    // Waits until a part of a message is sent. Received data do not extend this timeout, so that a client that sends but never reads is disconnected.
    async Task BecomesSentAsync(Task sending)
    {
        try
        {
            await sending.WaitAsync(_reader.PongTimeout, _reader.Time);
            _reader.OnWaited();
        }
        catch (TimeoutException)
        {
            // Aborts without a close frame, which a client that does not read would not receive.
            Interlocked.CompareExchange(ref _ended, (int)Closure.Silence, NotEnded);
            _socket.Abort();
            await sending;
        }
    }

    Task PumpAsync(Subscription subscription) => PumpAsync(() => subscription.PumpAsync(next => SendAsync(next, isReply: false), _stop.Token));

    static async Task PumpAsync(Func<Task> pump)
    {
        try
        {
            await pump();
        }
        catch (Exception e) when (IsEndOfConnection(e))
        {
            // The receiving loop ends the connection.
        }
    }

    // Aborts only for a client that does not read, because an abort discards unsent data, including the close frame.
    async Task StopPumpsAsync(Task replying, bool isGone)
    {
        var pumps = Task.WhenAll([replying, .. _switches.Values.Select(one => one.Ended)]);
        if (isGone || await Task.WhenAny(pumps, Task.Delay(CloseTimeout, _reader.Time)) != pumps)
            _socket.Abort();
        await pumps;
    }

    async Task CloseAsync(Closure why)
    {
        using var timeout = new CancellationTokenSource(CloseTimeout, _reader.Time);
        try
        {
            // Responds to the client's close frame with the same code.
            if (why == Closure.ByPeer)
                await _socket.CloseOutputAsync(_socket.CloseStatus ?? WebSocketCloseStatus.NormalClosure, null, timeout.Token);
            else
                await _socket.CloseOutputAsync(StatusOf(why), why.ToString(), timeout.Token);
            if (Ended != null)
                await Task.Delay(CloseTimeout, _reader.Time, _stop.Token);
            else if (why != Closure.ByPeer)
                await _receiver.DrainAsync(CloseTimeout);
        }
        catch (Exception e) when (IsEndOfConnection(e) || e is InvalidOperationException)
        {
            // The connection has already ended.
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
