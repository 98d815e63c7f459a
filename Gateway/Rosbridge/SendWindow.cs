namespace Nowpose.Gateway.Rosbridge;

/// <summary>Limits how many bytes are on their way to a client: those that were sent and that it has not read yet.</summary>
/// <remarks>
/// The buffers between the gateway and the client's own read call (TLS, both kernels, proxies) hold seconds of samples for a slow
/// reader, and no system call shows all of them. A ping in the stream does: its pong says that everything before it was read. The window
/// is what the client reads in about <see cref="Target"/>. A ping goes in a packet of its own: by it TCP notices a lost packet sooner, and
/// sent along with messages it cost over lossy links nearly a tenth of the reduction (Benchmarks -- links: 86 instead of 94 %). Takes the time as an argument; not thread-safe.
/// </remarks>
sealed class SendWindow
{
    /// <summary>A window this long keeps two messages of an arm on their way, because the last one may exceed it; a reader of 1 kB/s needs a second for them.</summary>
    internal const int MinBytes = 512;

    /// <summary>Before the first pong. At 4 kB/s it is read within a third of a second.</summary>
    internal const int FirstBytes = 1280;

    /// <summary>For a client that answers within <see cref="Quick"/>: half as many pings, and at 4 kB/s still read within two thirds of a second.</summary>
    internal const int QuickBytes = 2560;

    internal const int MaxBytes = 256 * 1024;

    static readonly TimeSpan Quick = TimeSpan.FromMilliseconds(50);

    /// <summary>A ping stands at least half a window behind the oldest unread byte, so at most twice this is on its way.</summary>
    internal static readonly TimeSpan Target = TimeSpan.FromMilliseconds(200);

    /// <summary>A client that has not answered the first ping by then is sent everything: only the buffers of its connection limit what waits for it.</summary>
    /// <remarks>A client that reads 700 bytes a second answers in time.</remarks>
    internal static readonly TimeSpan FirstPongTimeout = TimeSpan.FromSeconds(2);

    /// <summary>Window size of a client whose window was not full, as a multiple of what was on its way.</summary>
    const double Reserve = 1.5;

    long _sent;
    long _read;
    long _pingPosition;
    long _pingId;
    TimeSpan? _pingAt;
    bool _wasFull;
    bool _mayGrow;
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

    /// <summary>Whether a ping should come first: behind a long message the first pong would take as long as that.</summary>
    public bool IsPingDueBefore(int bytes) => !_hasAnswered && _pingAt == null && bytes > FirstBytes;

    /// <summary>Whether a ping should follow what was sent.</summary>
    public bool IsPingDue => _pingAt == null && 2 * (_sent - Math.Max(_read, _pingPosition)) >= Math.Min(Size, QuickBytes);

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
        var unread = Unread;
        var hadData = _pingPosition > _read;
        _read = _pingPosition;
        _hasAnswered = true;
        _isUnlimited = false;
        // The pong of an idle connection says nothing about how fast the client could read.
        if (hadData) Resize(now - pingAt, unread);
        _mayGrow = _wasFull;
        _wasFull = false;
    }

    // A full window grows with the next pong: the first one of a client that has just become slow is still a quick one.
    // A window that is not full shrinks to what it needs: a burst of messages must not leave it large for a client that becomes slow later.
    void Resize(TimeSpan took, long unread)
    {
        var factor = Math.Clamp(Target / (took + TimeSpan.FromTicks(1)), 0.25, 2);
        var size = took > Target || _mayGrow ? Size * factor : Math.Min(Size, Math.Max(QuickBytes, Reserve * unread));
        Size = (int)Math.Clamp(size, took < Quick ? QuickBytes : MinBytes, MaxBytes);
    }
}
