using System.Net.WebSockets;
using System.Text;
using Nowpose.Gateway.Sync;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>Receives the messages of a client. Skips a message that breaks a limit, as long as it ends within a maximum time and size.</summary>
/// <param name="longest">Maximum length of a message in bytes. Longer messages are dropped.</param>
sealed class MessageReceiver(
    WebSocket socket, FragmentCounter fragments, GatewayOptions options, int longest, RequestRate rate, TimeProvider time)
{
    const int FirstBytes = 4096;

    /// <summary>
    /// Topic whose messages may be longer than others. Stored without its leading slash, because JSON may escape the slash as "\/".
    /// </summary>
    static readonly byte[] LongTopic = Encoding.UTF8.GetBytes(RosTopics.RobotDescription.TrimStart('/'));

    /// <summary>Pause after a message beyond the client's rate limit. TCP flow control then slows the client down.</summary>
    static readonly TimeSpan Pause = TimeSpan.FromMilliseconds(50);

    byte[] _buffer = new byte[FirstBytes];
    long _length;
    long? _startedAt;
    Task<ValueWebSocketReceiveResult> _receiving;

    public async Task<Received> NextAsync()
    {
        _length = 0;
        _startedAt = null;
        while (true)
        {
            _receiving = socket.ReceiveAsync(Room(), CancellationToken.None).AsTask();
            if (!await IsInTimeAsync(_receiving) || _length > options.DrainBytes)
                return Received.Ended(Closure.EndlessMessage);
            var result = await _receiving;
            if (result.MessageType == WebSocketMessageType.Close)
                return Received.Ended(Closure.ByPeer);
            _startedAt ??= time.GetTimestamp();
            _length += result.Count;
            if (result.EndOfMessage)
                return await FinishAsync(result.MessageType, time.GetTimestamp());
        }
    }

    /// <summary>
    /// Reads and discards messages after <see cref="NextAsync"/> has returned the end, until the client closes the connection or the time is up.
    /// </summary>
    /// <remarks>Closing a socket with unread bytes resets the connection, and the client might not receive the reason for the closure.</remarks>
    /// <param name="atMost">Maximum time.</param>
    public async Task DrainAsync(TimeSpan atMost)
    {
        var timeUp = Task.Delay(atMost, time);
        while (await Task.WhenAny(_receiving, timeUp) == _receiving
            && (await _receiving).MessageType != WebSocketMessageType.Close)
            _receiving = socket.ReceiveAsync(_buffer.AsMemory(), CancellationToken.None).AsTask();
    }

    // Returns the free part of the buffer. Beyond the maximum length, returns the start of the buffer, because the message is dropped anyway.
    Memory<byte> Room()
    {
        if (_length >= longest)
            return _buffer.AsMemory(0, FirstBytes);
        if (_length == _buffer.Length)
            Array.Resize(ref _buffer, Math.Min(_buffer.Length * 2, longest));
        return _buffer.AsMemory((int)_length);
    }

    // The timeout applies from the start of a message. Waiting for the start has no timeout.
    async Task<bool> IsInTimeAsync(Task receiving)
    {
        if (_startedAt is not { } startedAt || receiving.IsCompleted)
            return true;
        var left = options.MessageTimeout + options.DrainTimeout - time.GetElapsedTime(startedAt);
        if (left <= TimeSpan.Zero)
            return false;
        using var waited = new CancellationTokenSource();
        var first = await Task.WhenAny(receiving, Task.Delay(left, time, waited.Token));
        await waited.CancelAsync();
        return first == receiving;
    }

    async Task<Received> FinishAsync(WebSocketMessageType type, long count)
    {
        var fault = FaultOf(type, fragments.Take());
        var message = fault == DropReason.None ? _buffer.AsMemory(0, (int)_length) : default;
        if (_buffer.Length > ProtocolLimits.MessageBytes)
            _buffer = new byte[FirstBytes];
        if (fault == DropReason.TooManyMessages)
            await Task.Delay(Pause, time);
        return new Received(message, fault, null, count);
    }

    DropReason FaultOf(WebSocketMessageType type, int count)
    {
        if (!rate.TryTake())
            return DropReason.TooManyMessages;
        if (_length > longest || (_length > ProtocolLimits.MessageBytes && _buffer.AsSpan(0, (int)_length).IndexOf(LongTopic) < 0))
            return DropReason.TooLarge;
        if (count > ProtocolLimits.FragmentsPerMessage)
            return DropReason.TooManyFragments;
        if (time.GetElapsedTime(_startedAt.Value) > options.MessageTimeout)
            return DropReason.TooSlow;
        return type == WebSocketMessageType.Text ? DropReason.None : DropReason.NotJson;
    }
}
