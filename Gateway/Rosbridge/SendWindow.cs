namespace Nowpose.Gateway.Rosbridge;

/// <summary>Limits the number of bytes that were sent to a client and that the client has not read yet.</summary>
/// <remarks>
/// The buffers between the gateway and the client's read call (TLS, both kernels, proxies) can hold seconds of samples for a slow reader, and
/// no system call reports the content of all of them. Instead, pings are sent in the stream: a pong confirms that the client has read all
/// bytes before the ping. The window is the number of bytes that the client reads in about <see cref="Target"/>. Each ping is sent in a
/// separate packet, because TCP then detects a lost packet sooner. If pings were sent in the packets of messages, the error reduction over
/// lossy links would be 86 % instead of 94 % (Benchmarks -- links). Takes the time as an argument; not thread-safe.
/// </remarks>
sealed class SendWindow
{
    /// <summary>Window size for a slow reader, in bytes. It allows one message at a time, because the last message may exceed the window.</summary>
    const int OneMessage = 1;

    /// <summary>
    /// Minimum window size for a client that reads it and the longest message within <see cref="MaxReadTime"/>, in bytes. It allows two messages of an
    /// arm for a client that reads 1.2 kB/s.
    /// </summary>
    internal const int MinBytes = 512;

    /// <summary>Window size before the first pong, in bytes. A client reads it within a third of a second at 4 kB/s.</summary>
    internal const int FirstBytes = 1280;

    /// <summary>
    /// Minimum window size for a client that answers pings within <see cref="Quick"/> and reads it and the longest message within
    /// <see cref="MaxReadTime"/>, in bytes. A client reads it within two thirds of a second at 4 kB/s.
    /// </summary>
    internal const int QuickBytes = 2560;

    /// <summary>
    /// Maximum number of bytes after which a ping is due, except to a near client. With more frequent pings, TCP detects more lost packets early.
    /// </summary>
    const int PingBytes = 1280;

    /// <summary>Number of bytes after which a ping to a near client is due. A near client answers pings within <see cref="Near"/>.</summary>
    /// <remarks>
    /// With a ping after each <see cref="PingBytes"/>, pings would be a third of the gateway's work for 200 headsets at 50 Hz.
    /// </remarks>
    internal const int NearPingBytes = 1900;

    internal const int MaxBytes = 256 * 1024;

    static readonly TimeSpan Quick = TimeSpan.FromMilliseconds(50);

    static readonly TimeSpan Near = TimeSpan.FromMilliseconds(10);

    /// <summary>Time in which a client should read a full window. A ping is due after half a window of unread data.</summary>
    internal static readonly TimeSpan Target = TimeSpan.FromMilliseconds(200);

    /// <summary>
    /// Timeout of the first pong. Afterwards, the read rate is assumed to be <see cref="AssumedBytesPerSecond"/>.
    /// </summary>
    /// <remarks>A client that reads 700 bytes per second answers pings within this time.</remarks>
    internal static readonly TimeSpan FirstPongTimeout = TimeSpan.FromSeconds(2);

    /// <summary>Assumed read rate of a client that does not answer pings, whose actual read rate cannot be measured.</summary>
    /// <remarks>TCP transmits only 2.5 kB/s to a client that has a receive buffer of 1 KiB and could read 4 kB/s.</remarks>
    internal const double AssumedBytesPerSecond = 2000;

    /// <summary>Maximum time for reading one message. Together with 0.15 s in the queue, a sample is then at most a second old.</summary>
    internal static readonly TimeSpan MaxReadTime = TimeSpan.FromMilliseconds(850);

    /// <summary>
    /// Number of pongs later than <see cref="MaxReadTime"/> after which the client counts as too slow, if no other pong arrives between them. More than
    /// one is required, because a lossy network delays individual pongs.
    /// </summary>
    internal const int MaxLatePongs = 5;

    /// <summary>
    /// Number of pongs in time that cancel one late pong. A slow client reads the short messages between long ones in time, whereas a client behind a
    /// lossy network answers most pings in time.
    /// </summary>
    const int PongsPerLatePong = 3;

    /// <summary>Number of pongs over which the length of the longest message decreases if only shorter messages follow.</summary>
    const int DecayPongs = 16;

    /// <summary>Minimum size to which a window that was not full shrinks, as a multiple of the unread bytes.</summary>
    const double Reserve = 1.25;

    /// <summary>Number of newest pongs whose mean read rate determines the window on a lossy path.</summary>
    const int RatedPongs = 8;

    /// <summary>
    /// Minimum ratio of the read rate at a pong in time to the rate at the late pong just before it, for which the late pong counts as the
    /// effect of a lost packet. A slow reader reads at nearly the same rate at both pongs.
    /// </summary>
    const double RecoveryRatio = 2.5;

    /// <summary>Number of pongs for which the path counts as lossy after a recovery from a lost packet.</summary>
    const int LossyPongs = 256;

    /// <summary>
    /// Time in which a client should read a full window on a lossy path. After a lost packet, TCP delivers nothing for about 0.3 s, and then all
    /// waiting data at once. If the window closes in this time, the newest samples are sent a round trip later. With <see cref="Target"/>, the
    /// error reduction over the link "bad" would be 71 % instead of 93 % (Benchmarks -- links).
    /// </summary>
    static readonly TimeSpan LossyTarget = TimeSpan.FromMilliseconds(500);

    // Ring buffer of the newest pongs: the number of bytes confirmed, and the time in which the client read them.
    readonly (long Read, TimeSpan Time)[] _rated = new (long, TimeSpan)[RatedPongs];
    int _pongs;
    int _pongsSinceRecovery = LossyPongs;
    double? _lateRate;
    TimeSpan _unreadSince;
    long _sent;
    long _read;
    long _pingPosition;
    long _pingId;
    TimeSpan? _pingAt;
    bool _wasFull;
    bool _mayGrow = true;
    bool _hasAnswered;
    bool _hasPublished;
    int _longest;
    // Increases by PongsPerLatePong with a late pong, and decreases by 1 with a pong in time.
    int _lateness;
    // Whether the last part of a message was sent after the newest ping, and before it since the ping before.
    bool _hasEndAfterPing;
    bool _hasEndBeforePing;
    TimeSpan? _assumedUntil;

    /// <summary>Window size in bytes.</summary>
    public int Size { get; private set; } = OneMessage;

    /// <summary>Number of bytes sent to the client that no pong has confirmed as read.</summary>
    public long Unread => _sent - _read;

    /// <summary>
    /// Whether the client answered the newest ping within <see cref="Near"/> and has a window of at least <see cref="QuickBytes"/>.
    /// </summary>
    public bool IsNear { get; private set; }

    /// <summary>Whether the client's read rate is assumed, because the client has not answered a ping in time.</summary>
    public bool IsAssumed => !_hasAnswered && _assumedUntil != null;

    /// <summary>Whether the client reads so slowly that many of its samples are old, even if one message is sent at a time.</summary>
    public bool IsTooSlow => _lateness >= MaxLatePongs * PongsPerLatePong;

    /// <summary>Time at which the outstanding ping was sent; null if there is none.</summary>
    public TimeSpan? PingAt => _pingAt;

    /// <summary>Whether a message may be sent. The last message may exceed the window.</summary>
    /// <param name="isReply">
    /// Whether the message is the response to a request. Before the first pong, only one message that is not a reply is sent.
    /// </param>
    public bool IsOpen(TimeSpan now, bool isReply = false)
    {
        if (!_hasAnswered && now - _pingAt >= FirstPongTimeout) AssumeRead(now);
        var isOpen = _hasAnswered ? Unread < Size : Unread < FirstBytes && (isReply || IsAssumed || !_hasPublished);
        _wasFull |= !isOpen;
        return isOpen;
    }

    /// <param name="isEnd">False for a part of a message that is followed by another part.</param>
    public void OnSent(int bytes, TimeSpan now, bool isReply = false, bool isEnd = true)
    {
        _hasEndAfterPing |= isEnd;
        _longest = Math.Max(_longest, bytes);
        if (Unread == 0) _unreadSince = now;
        _sent += bytes;
        _hasPublished |= !isReply;
    }

    /// <summary>Whether a ping should be sent before a message, because the message is so long that it would delay the first pong.</summary>
    public bool IsPingDueBefore(int bytes) => !_hasAnswered && _pingAt == null && bytes > FirstBytes;

    /// <summary>Whether a ping should follow the sent data.</summary>
    public bool IsPingDue => _pingAt == null && _sent - Math.Max(_read, _pingPosition) >= PingDueBytes;

    /// <summary>Records a ping at the end of the sent data.</summary>
    /// <returns>The number of the ping, which the pong repeats.</returns>
    public long OnPing(TimeSpan now)
    {
        _pingAt = now;
        _pingPosition = _sent;
        (_hasEndBeforePing, _hasEndAfterPing) = (_hasEndAfterPing, false);
        return ++_pingId;
    }

    /// <summary>Processes a pong. Ignores a pong that does not answer the newest ping.</summary>
    public void OnPong(long id, TimeSpan now)
    {
        if (_pingAt is not { } pingAt || id != _pingId) return;
        _pingAt = null;
        var unread = Unread;
        var read = _pingPosition - _read;
        _read = _pingPosition;
        _hasAnswered = true;
        // Ignores the time of a pong that confirms no bytes, because it does not show how fast the client can read.
        if (read > 0)
        {
            var time = now - _unreadSince + TimeSpan.FromTicks(1);
            _rated[_pongs++ % RatedPongs] = (read, time);
            Resize(now - pingAt, read, read / time.TotalSeconds, unread);
        }

        _unreadSince = now;
        // Requires this size, because a smaller window would be full before a ping is due.
        IsNear = now - pingAt < Near && Size >= QuickBytes;
        _mayGrow = _wasFull;
        _wasFull = false;
    }

    int PingDueBytes => IsNear ? NearPingBytes : _hasAnswered || _hasPublished ? Math.Clamp(Size / 2, 1, PingBytes) : FirstBytes / 2;

    void AssumeRead(TimeSpan now)
    {
        var since = _assumedUntil ?? now - FirstPongTimeout;
        var read = (long)(AssumedBytesPerSecond * (now - since).TotalSeconds);
        if (read == 0) return;
        _assumedUntil = now;
        _read = Math.Min(_sent, _read + read);
    }

    void Resize(TimeSpan took, long read, double readRate, long unread)
    {
        // Does not judge the time for a part of a long message, which is longer than a sample.
        if (_hasEndBeforePing) _lateness = took > MaxReadTime ? _lateness + PongsPerLatePong : Math.Max(0, _lateness - 1);
        var isLate = took > Target;
        _pongsSinceRecovery = !isLate && readRate > RecoveryRatio * _lateRate ? 0 : _pongsSinceRecovery + 1;
        _lateRate = isLate ? readRate : null;
        var size = SizeFor(took, read, unread);
        if (_pongsSinceRecovery < LossyPongs) size = Math.Max(isLate ? 0 : size, MeanRate * LossyTarget.TotalSeconds);
        // Requires a read rate for a minimum size, because a quick pong for a few bytes does not show that the client can read more.
        var min = took < Quick && CanRead(QuickBytes, readRate) ? QuickBytes : CanRead(MinBytes, readRate) ? MinBytes : OneMessage;
        Size = (int)Math.Clamp(size, min, MaxBytes);
        _longest -= _longest / DecayPongs;
    }

    // Whether a client reads a window of this size and one more message, which may exceed the window, in time. A longer message may still come.
    bool CanRead(int bytes, double readRate) => bytes + Math.Max(_longest, MinBytes) <= readRate * MaxReadTime.TotalSeconds;

    // A window that was full grows one pong later, because a client that has just become slow still answers the first ping quickly.
    // A window that was not full shrinks to the size in use, so that it is not too large for a client that becomes slow after a burst.
    double SizeFor(TimeSpan took, long read, long unread)
    {
        var factor = Math.Clamp(Target / (took + TimeSpan.FromTicks(1)), 0.25, 2);
        return took > Target || _mayGrow ? Math.Max(Size, read) * factor : Math.Min(Size, Math.Max(QuickBytes, Reserve * unread));
    }

    // Mean read rate over the newest pongs, in bytes per second.
    double MeanRate
    {
        get
        {
            var (read, time) = (0L, TimeSpan.FromTicks(1));
            foreach (var pong in _rated) (read, time) = (read + pong.Read, time + pong.Time);
            return read / time.TotalSeconds;
        }
    }
}
