using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Security.Authentication;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Sync;

/// <summary>The sync connection of one headset, served by its own thread.</summary>
sealed class ServedSyncConnection
{
    const int NotStopped = -1;

    readonly Socket _socket;
    readonly GatewayOptions _options;
    readonly IControlClock _clock;
    readonly AccessWatch _access;
    readonly WrongTokens _wrong;
    readonly PendingConnection _pending;
    readonly object _delay = new();
    readonly Action<ServedSyncConnection, Closure, Exception> _ended;
    readonly RequestRate _rate;
    readonly Thread _thread;
    readonly byte[] _frame = new byte[SyncFrame.Size];
    bool _isAccepted;
    IDisposable _watched;
    IDisposable _place;
    int _stopped = NotStopped;
    volatile bool _isOverdue;

    // The reason to report if the deadline passes.
    Closure _awaited;

    /// <param name="pending">
    /// Entry among the pending connections. It is disposed after the first frame of an authenticated client, or at the end.
    /// </param>
    /// <param name="ended">
    /// Called at the end on the connection's thread, with the reason and the exception; the exception is null for a normal end.
    /// </param>
    public ServedSyncConnection(
        Socket socket, GatewayOptions options, IControlClock clock, AccessWatch access, WrongTokens wrong, PendingConnection pending,
        Action<ServedSyncConnection, Closure, Exception> ended)
    {
        _socket = socket;
        _options = options;
        _clock = clock;
        _access = access;
        _wrong = wrong;
        Address = pending.Address;
        _pending = pending;
        _ended = ended;
        _isAccepted = !options.AsksForTokens;
        _rate = new RequestRate(options.SyncRequestsPerSecond);
        _thread = new Thread(Run) { IsBackground = true, Name = "sync connection", Priority = ThreadPriority.AboveNormal };
    }

    public IPAddress Address { get; }

    /// <summary>Role of the accepted token; null without one.</summary>
    public Role? Role { get; private set; }

    /// <summary>Hash of the newest token; null if the client has sent none.</summary>
    public byte[] TokenHash { get; private set; }

    public void Start() => _thread.Start();

    /// <summary>Ends the connection. Thread-safe.</summary>
    public void Stop(Closure why)
    {
        Interlocked.CompareExchange(ref _stopped, (int)why, NotStopped);
        lock (_delay) Monitor.PulseAll(_delay);
        _socket.Dispose();
    }

    public void Join()
    {
        if (_thread.ThreadState.HasFlag(ThreadState.Unstarted))
            return;
        _thread.Join(TimeSpan.FromSeconds(5));
    }

    void Run()
    {
        var why = Closure.ByPeer;
        var cause = default(Exception);
        try
        {
            why = Serve();
        }
        catch (Exception e)
        {
            // Catches all exceptions, because an unhandled exception on a thread ends the process.
            why = Explain(e);
            cause = e;
        }

        _watched?.Dispose();
        _place?.Dispose();
        _pending.Dispose();
        var stopped = Volatile.Read(ref _stopped);
        // Reports the end before the client can detect it.
        _ended(this, stopped == NotStopped ? why : (Closure)stopped, cause);
        _socket.Dispose();
    }

    Closure Serve()
    {
        _socket.NoDelay = true;
        using var stream = new NetworkStream(_socket, false);
        using var deadline = new Timer(_ => Overdue(), null, _options.TokenTimeout, Timeout.InfiniteTimeSpan);
        if (_options.Certificate == null)
            return Exchange(stream, deadline);
        _awaited = Closure.TlsHandshake;
        using var secure = new SslStream(stream);
        secure.AuthenticateAsServer(_options.ServerCertificate.ForConnection());
        _pending.CompleteHandshake();
        return Exchange(secure, deadline);
    }

    Closure Exchange(Stream stream, Timer deadline)
    {
        // Until a required token has been received, a single deadline applies to all frames.
        _awaited = Closure.Token;
        if (_isAccepted)
            AwaitNext(deadline);
        while (true)
        {
            var read = ReadFrame(stream, deadline);
            if (read == 0)
                return Closure.ByPeer;
            // Reads the time first, because any work before it would count as network latency.
            var t2 = _clock.Now;
            var bound = _clock.ErrorBound;
            if (!_rate.TryTake())
                return Closure.TooManyRequests;
            if (!SyncFrame.TryRead(_frame.AsSpan(0, read), out var frame, out _) || !Answer(stream, frame, t2, bound))
                return Closure.MalformedFrame;
            if (!_isAccepted)
                continue;
            _pending.Dispose();
            AwaitNext(deadline);
        }
    }

    void AwaitNext(Timer deadline)
    {
        _awaited = Closure.Silence;
        deadline.Change(_options.SyncSilence, Timeout.InfiniteTimeSpan);
    }

    // Reads a frame, and returns the number of bytes; less than a frame if the client ends the connection. Once a frame has begun, it must be complete
    // before a deadline. Otherwise a client could keep the connection open by sending single bytes.
    int ReadFrame(Stream stream, Timer deadline)
    {
        var begun = stream.Read(_frame);
        if (begun > 0 && begun < _frame.Length && _isAccepted)
            deadline.Change(_options.TokenTimeout, Timeout.InfiniteTimeSpan);
        return begun == 0 ? 0 : begun + stream.ReadAtLeast(_frame.AsSpan(begun), _frame.Length - begun, false);
    }

    bool Answer(Stream stream, in SyncFrame frame, ControlTime t2, TimeSpan boundAtT2)
    {
        if (frame.Kind == SyncFrameKind.Token)
            return AnswerToken(stream);
        if (!_isAccepted || frame.Kind != SyncFrameKind.Request)
            return false;
        var synchronised = _clock.IsSynchronised;
        // The estimate of the plant's clock may have been updated since t2, so the larger of the two bounds applies to both times.
        var boundNow = _clock.ErrorBound;
        var bound = boundNow > boundAtT2 ? boundNow : boundAtT2;
        var resolution = (uint)Math.Min(uint.MaxValue, _clock.Resolution.Ticks * 100);
        // Prevents t3 < t2: the control time may step back when the estimate of the plant's clock is updated.
        var t3 = Math.Max(t2.Nanoseconds, _clock.Now.Nanoseconds);
        SyncFrame.Reply(frame, t2.Nanoseconds, t3, synchronised, bound, resolution).Write(_frame);
        stream.Write(_frame);
        return true;
    }

    // Responds to a token. A gateway without tokens accepts any token, so that a headset with a token can connect.
    bool AnswerToken(Stream stream)
    {
        var length = new byte[SyncToken.LengthSize];
        if (!TryFill(stream, length) || !SyncToken.TryReadLength(length, out var count))
            return false;
        var text = new byte[count];
        if (!TryFill(stream, text) || !SyncToken.TryReadText(text, out var token))
            return false;
        var hash = TokenHash = TokenList.HashOf(token);
        var role = _options.RoleOf(hash);
        var isValid = role != null || !_options.AsksForTokens;
        if (role != null)
        {
            _place?.Dispose();
            _place = _access.Sources.TryEnter(hash, role.Value, Address);
            if (_place == null)
            {
                Stop(Closure.SourceLimit);
                return false;
            }

            _isAccepted = true;
            Role = role;
            _watched?.Dispose();
            _watched = _access.Watch(hash, role.Value, Stop);
        }

        if (!isValid) SlowDown();
        // Replies about this token; after a valid token, a wrong token does not end the access.
        SyncFrame.TokenReply(isValid).Write(_frame);
        stream.Write(_frame);
        return true;
    }

    // Delays the response to a wrong token. The response to a valid token is not delayed, even if its address has sent many wrong tokens.
    void SlowDown()
    {
        if (!_wrong.Count(Address)) return;
        lock (_delay)
            if (Volatile.Read(ref _stopped) == NotStopped && !_isOverdue) Monitor.Wait(_delay, _options.WrongTokenDelay);
    }

    void Overdue()
    {
        _isOverdue = true;
        // Wakes the connection's thread if it is delaying a response, because the connection ends now.
        lock (_delay) Monitor.PulseAll(_delay);
        _socket.Dispose();
    }

    Closure Explain(Exception e)
    {
        if (e is AuthenticationException)
            return Closure.TlsHandshake;
        if (e is not (IOException or SocketException or ObjectDisposedException))
            return Closure.Failure;
        return _isOverdue ? _awaited : Closure.ByPeer;
    }

    static bool TryFill(Stream stream, Span<byte> buffer) => stream.ReadAtLeast(buffer, buffer.Length, false) == buffer.Length;
}
