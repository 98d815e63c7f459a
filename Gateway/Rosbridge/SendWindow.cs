namespace Nowpose.Gateway.Rosbridge;

/// <summary>Limits the number of bytes that were sent to a client but not yet read by it.</summary>
/// <remarks>
/// The buffers between the gateway and the client's own read call (TLS, both kernels, proxies) can hold seconds of samples for a slow
/// reader, and no system call reports all of them. A ping in the stream does: its pong confirms that everything before it was read. The
/// window is the amount that the client reads in about <see cref="Target"/>. A ping is sent in a separate packet: TCP then detects a lost
/// packet sooner. Sent together with messages, pings cost nearly a tenth of the reduction over lossy links (Benchmarks -- links: 86 instead
/// of 94 %). Takes the time as an argument; not thread-safe.
/// </remarks>
sealed class SendWindow
{
    /// <summary>Window size for a slow reader: one message at a time, because the last one may exceed the window.</summary>
    const int OneMessage = 1;

    /// <summary>
    /// Minimum window size for a client that reads <see cref="MinBytesPerSecond"/>. It allows two messages of an arm, which are read within 0.8 s.
    /// </summary>
    internal const int MinBytes = 512;

    const double MinBytesPerSecond = 1200;

    /// <summary>Window size before the first pong. At 4 kB/s it is read within a third of a second.</summary>
    internal const int FirstBytes = 1280;

    /// <summary>
    /// Minimum window size for a client that answers within <see cref="Quick"/> and reads <see cref="QuickBytesPerSecond"/>. At 4 kB/s it is read
    /// within two thirds of a second.
    /// </summary>
    internal const int QuickBytes = 2560;

    const double QuickBytesPerSecond = 3500;

    /// <summary>Maximum number of bytes from one ping to the next. More pings let TCP detect more lost packets early.</summary>
    const int PingBytes = 1280;

    /// <summary>Maximum number of bytes between pings to a client that answers within <see cref="Near"/>, before the rest of the window is sent.</summary>
    /// <remarks>Pings are a third of the gateway's work for 200 headsets at 50 Hz when all are sent each <see cref="PingBytes"/>.</remarks>
    internal const int NearPingBytes = 1900;

    internal const int MaxBytes = 256 * 1024;

    static readonly TimeSpan Quick = TimeSpan.FromMilliseconds(50);

    static readonly TimeSpan Near = TimeSpan.FromMilliseconds(10);

    /// <summary>Target time to read a window. A ping is due after half a window of unread data.</summary>
    internal static readonly TimeSpan Target = TimeSpan.FromMilliseconds(200);

    /// <summary>
    /// Timeout of the first pong. A client that has answered no ping by then is assumed to read <see cref="AssumedBytesPerSecond"/>.
    /// </summary>
    /// <remarks>A client that reads 700 bytes per second answers in time.</remarks>
    internal static readonly TimeSpan FirstPongTimeout = TimeSpan.FromSeconds(2);

    /// <summary>Assumed read rate of a client that does not answer pings. Whether it is a slow one or a fast one cannot be measured.</summary>
    /// <remarks>With a receive buffer of 1 KiB, TCP carries only 2.5 kB/s to a client that could read 4 kB/s.</remarks>
    internal const double AssumedBytesPerSecond = 2000;

    /// <summary>Time to read one message above which its sample is more than a second old: the queue adds 0.15 s.</summary>
    internal static readonly TimeSpan MaxReadTime = TimeSpan.FromMilliseconds(850);

    /// <summary>Number of pongs in a row that are later than this, after which the client is too slow. A lossy network delays single ones.</summary>
    internal const int MaxLatePongs = 5;

    /// <summary>Window size of a client whose window was not full, as a multiple of its unread bytes.</summary>
    const double Reserve = 1.25;

    /// <summary>Number of newest pongs that determine the read rate on a lossy path.</summary>
    const int RatedPongs = 8;

    /// <summary>Minimum read rate after a lost packet, as a multiple of the rate before it. A slow reader reads at the same rate after a late pong.</summary>
    const double RecoveryRatio = 2.5;

    /// <summary>Number of pongs after a recovery for which the path counts as lossy.</summary>
    const int LossyPongs = 256;

    /// <summary>
    /// Target time to read a window on a lossy path. TCP delivers nothing for about 0.3 s after a lost packet; what waits meanwhile arrives at once,
    /// so a window that closes delays the newest samples by a round trip. With <see cref="Target"/>, the reduction over the link "bad" was 71
    /// instead of 93 % (Benchmarks -- links).
    /// </summary>
    static readonly TimeSpan LossyTarget = TimeSpan.FromMilliseconds(500);

    // The newest pongs, in a ring: the bytes that each confirmed, and the time in which the client read them.
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
    int _latePongs;
    TimeSpan? _assumedUntil;

    /// <summary>Window size, bytes.</summary>
    public int Size { get; private set; } = OneMessage;

    /// <summary>Number of sent bytes that are not confirmed as read.</summary>
    public long Unread => _sent - _read;

    /// <summary>Number of bytes that the client has to read before the newest ping.</summary>
    public long BytesBeforePing => Math.Max(0, _pingPosition - _read);

    /// <summary>Whether the client has answered a ping.</summary>
    public bool HasAnswered => _hasAnswered;

    /// <summary>Whether the client answered the newest ping within a few milliseconds.</summary>
    public bool IsNear { get; private set; }

    /// <summary>Whether the client's read rate is assumed, because it has not answered a ping in time.</summary>
    public bool IsAssumed => !_hasAnswered && _assumedUntil != null;

    /// <summary>Whether the client needs too much time for each single message, so that its samples are always old.</summary>
    public bool IsTooSlow => _latePongs >= MaxLatePongs;

    /// <summary>Time at which the outstanding ping was sent; null if there is none.</summary>
    public TimeSpan? PingAt => _pingAt;

    /// <summary>Whether a message may be sent; the last one may exceed the window.</summary>
    /// <param name="isReply">Whether the message answers a request. Of all others, only one is sent before the first pong.</param>
    public bool IsOpen(TimeSpan now, bool isReply = false)
    {
        if (!_hasAnswered && now - _pingAt >= FirstPongTimeout) AssumeRead(now);
        var isOpen = _hasAnswered ? Unread < Size : Unread < FirstBytes && (isReply || IsAssumed || !_hasPublished);
        _wasFull |= !isOpen;
        return isOpen;
    }

    public void OnSent(int bytes, TimeSpan now, bool isReply = false)
    {
        if (Unread == 0) _unreadSince = now;
        _sent += bytes;
        _hasPublished |= !isReply;
    }

    /// <summary>Whether a ping should be sent first: after a long message, the first pong would be delayed by it.</summary>
    public bool IsPingDueBefore(int bytes) => !_hasAnswered && _pingAt == null && bytes > FirstBytes;

    /// <summary>Whether a ping should follow the sent data.</summary>
    public bool IsPingDue => _pingAt == null && _sent - Math.Max(_read, _pingPosition) >= PingDueBytes;

    /// <summary>Records a ping at the end of the sent data.</summary>
    /// <returns>Its number, which the pong repeats.</returns>
    public long OnPing(TimeSpan now)
    {
        _pingAt = now;
        _pingPosition = _sent;
        return ++_pingId;
    }

    /// <summary>Processes a pong. Numbers other than that of the newest ping are ignored.</summary>
    public void OnPong(long id, TimeSpan now)
    {
        if (_pingAt is not { } pingAt || id != _pingId) return;
        _pingAt = null;
        var unread = Unread;
        var read = _pingPosition - _read;
        _read = _pingPosition;
        _hasAnswered = true;
        // The pong of an idle connection does not show how fast the client could read.
        if (read > 0)
        {
            var time = now - _unreadSince + TimeSpan.FromTicks(1);
            _rated[_pongs++ % RatedPongs] = (read, time);
            Resize(now - pingAt, read, read / time.TotalSeconds, unread);
        }

        _unreadSince = now;
        // With a smaller window, no ping would ever be due.
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
        _latePongs = took > MaxReadTime ? _latePongs + 1 : 0;
        var isLate = took > Target;
        _pongsSinceRecovery = !isLate && readRate > RecoveryRatio * _lateRate ? 0 : _pongsSinceRecovery + 1;
        _lateRate = isLate ? readRate : null;
        var size = SizeFor(took, read, unread);
        if (_pongsSinceRecovery < LossyPongs) size = Math.Max(isLate ? 0 : size, MeanRate * LossyTarget.TotalSeconds);
        // A pong for a few bytes does not show that the client can read more.
        var min = took < Quick && readRate >= QuickBytesPerSecond ? QuickBytes : readRate >= MinBytesPerSecond ? MinBytes : OneMessage;
        Size = (int)Math.Clamp(size, min, MaxBytes);
    }

    // A full window grows with the next pong, because the first pong of a client that has just become slow is still fast.
    // A window that is not full shrinks to what it needs: after a burst of messages, it must not stay large for a client that becomes slow later.
    double SizeFor(TimeSpan took, long read, long unread)
    {
        var factor = Math.Clamp(Target / (took + TimeSpan.FromTicks(1)), 0.25, 2);
        return took > Target || _mayGrow ? Math.Max(Size, read) * factor : Math.Min(Size, Math.Max(QuickBytes, Reserve * unread));
    }

    // Read rate over the newest pongs, bytes per second.
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
