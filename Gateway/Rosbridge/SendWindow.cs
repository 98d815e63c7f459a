namespace Nowpose.Gateway.Rosbridge;

/// <summary>Limits how many bytes are on their way to a client: those that were sent and that it has not read yet.</summary>
/// <remarks>
/// The buffers between the gateway and the client's own read call (TLS, both kernels, proxies) hold seconds of samples for a slow
/// reader, and no system call shows all of them. A ping in the stream does: its pong says that everything before it was read. The window
/// is what the client reads in about <see cref="Target"/>, without the round trip: the shortest time from a ping to its pong. Takes the
/// time as an argument; not thread-safe.
/// </remarks>
sealed class SendWindow
{
    /// <summary>The smallest window lets one message go at a time.</summary>
    internal const int MinBytes = 1;

    /// <summary>Before the first pong: one message of an arm, and the ping before it measures the round trip.</summary>
    internal const int FirstBytes = 256;

    /// <summary>
    /// For a client whose last pongs all took less than <see cref="Quick"/>: fewer pings, and still read within a second by one that suddenly
    /// reads no more than 2 kB/s.
    /// </summary>
    internal const int QuickBytes = 1536;

    // A slow client may read its first messages at once.
    const int TrustedPongs = 5;

    internal const int MaxBytes = 256 * 1024;

    static readonly TimeSpan Quick = TimeSpan.FromMilliseconds(50);

    /// <summary>A ping stands at least half a window behind the oldest unread byte, so at most twice this is on its way.</summary>
    internal static readonly TimeSpan Target = TimeSpan.FromMilliseconds(200);

    /// <summary>A client that has answered no ping by then is sent everything: only the kernel's send buffer limits what waits for it.</summary>
    internal static readonly TimeSpan FirstPongTimeout = TimeSpan.FromSeconds(1);

    long _sent;
    long _read;
    long _pingPosition;
    long _pingId;
    TimeSpan? _pingAt;
    TimeSpan _pongAt;
    TimeSpan _roundTrip = TimeSpan.MaxValue;
    int _promptPongs;
    bool _wasFull;
    bool _hasAnswered;
    bool _isUnlimited;

    /// <summary>Window size, bytes.</summary>
    public int Size { get; private set; } = FirstBytes;

    /// <summary>Bytes that were sent and are not known to be read.</summary>
    public long Unread => _sent - _read;

    /// <summary>Bytes that the client has to read before the newest ping.</summary>
    public long BytesBeforePing => _pingPosition - _read;

    /// <summary>Whether the client has answered a ping.</summary>
    public bool HasAnswered => _hasAnswered;

    /// <summary>When the ping that has no pong yet was sent; null without one.</summary>
    public TimeSpan? PingAt => _pingAt;

    /// <summary>Whether a message may be sent; the last one may exceed the window.</summary>
    public bool IsOpen(TimeSpan now)
    {
        if (!_hasAnswered && now - _pingAt >= FirstPongTimeout) _isUnlimited = true;
        var isOpen = _isUnlimited || Unread < Size;
        _wasFull |= !isOpen;
        return isOpen;
    }

    public void OnSent(int bytes) => _sent += bytes;

    /// <summary>Whether a ping should go with the next message and before it. The first one measures the round trip.</summary>
    public bool IsPingDueBefore => _pingAt == null && (_pingId == 0 || 2 * (_sent - Math.Max(_read, _pingPosition)) >= Size);

    /// <summary>Whether a ping should follow at once: no message can be sent before the next pong.</summary>
    public bool IsPingDue => _pingAt == null && Unread >= Size;

    /// <summary>Notes a ping at the end of what was sent.</summary>
    /// <returns>Its number, which the pong repeats.</returns>
    public long OnPing(TimeSpan now)
    {
        _pingAt = now;
        _pingPosition = _sent;
        return ++_pingId;
    }

    /// <summary>Takes a pong. Other numbers than that of the newest ping are ignored.</summary>
    public void OnPong(long id, TimeSpan now)
    {
        if (_pingAt is not { } pingAt || id != _pingId) return;
        _pingAt = null;
        var bytes = BytesBeforePing;
        _read = _pingPosition;
        _hasAnswered = true;
        _isUnlimited = false;
        var took = now - pingAt;
        if (took < _roundTrip) _roundTrip = took;
        if (bytes > 0)
        {
            _promptPongs = took - _roundTrip < Quick ? _promptPongs + 1 : 0;
            // A connection that is idle, or slower than its window, says nothing about how fast the client could read. While the window was
            // full, the client had always something to read.
            if (_wasFull || took > Target + _roundTrip) Size = Fitted(bytes, _wasFull ? now - _pongAt : took);
            if (_promptPongs >= TrustedPongs && took < Quick) Size = Math.Max(Size, QuickBytes);
        }

        _pongAt = now;
        _wasFull = false;
    }

    // What it reads in a round trip and the target time, at the rate at which it has read these bytes. A client that keeps up shows only the
    // lowest rate that it may have.
    int Fitted(long bytes, TimeSpan elapsed)
    {
        var fitted = _promptPongs > 1 ? double.MaxValue : bytes * ((Target + _roundTrip) / elapsed);
        return (int)Math.Clamp(Math.Clamp(fitted, Size / 4, 2L * Size), MinBytes, MaxBytes);
    }
}
