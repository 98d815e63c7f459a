using System.Net.Security;
using System.Net.Sockets;
using System.Security.Authentication;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Sync;

/// <summary>One headset's sync connection, served by one thread.</summary>
sealed class SyncConnection
{
    readonly Socket _socket;
    readonly GatewayOptions _options;
    readonly IControlClock _clock;
    readonly Action<SyncConnection, Closure, Exception> _ended;
    readonly RequestRate _rate;
    readonly Thread _thread;
    readonly byte[] _frame = new byte[SyncFrame.Size];
    bool _isAccepted;
    volatile bool _isStopped;
    volatile bool _isOverdue;

    // What the deadline ends.
    Closure _awaited = Closure.Token;

    /// <param name="ended">Takes why it ended, and the exception that ended it or null; on the connection's thread.</param>
    public SyncConnection(
        Socket socket, GatewayOptions options, IControlClock clock, Action<SyncConnection, Closure, Exception> ended)
    {
        _socket = socket;
        _options = options;
        _clock = clock;
        _ended = ended;
        _isAccepted = !options.AsksForTokens;
        _rate = new RequestRate(options.SyncRequestsPerSecond);
        _thread = new Thread(Run) { IsBackground = true, Name = "sync connection", Priority = ThreadPriority.AboveNormal };
    }

    public void Start() => _thread.Start();

    public void Stop()
    {
        _isStopped = true;
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
            // All of them: an exception that leaves a thread ends the process, and every other connection.
            why = Explain(e);
            cause = e;
        }

        // Counted before the peer can see the end.
        _ended(this, _isStopped ? Closure.Stopped : why, cause);
        _socket.Dispose();
    }

    Closure Serve()
    {
        _socket.NoDelay = true;
        _socket.SendTimeout = _socket.ReceiveTimeout = (int)_options.SyncSilence.TotalMilliseconds;
        using var stream = new NetworkStream(_socket, false);
        // A peer that sends a byte now and then is never silent: handshake and token have an end of their own.
        using var deadline = new Timer(_ => Overdue(), null, _options.TokenTimeout, Timeout.InfiniteTimeSpan);
        if (_options.Certificate == null)
            return Exchange(stream, deadline);
        _awaited = Closure.TlsHandshake;
        using var secure = new SslStream(stream);
        secure.AuthenticateAsServer(new SslServerAuthenticationOptions
        {
            ServerCertificate = _options.Certificate,
            EnabledSslProtocols = SslProtocols.Tls12 | SslProtocols.Tls13,
        });
        _awaited = Closure.Token;
        return Exchange(secure, deadline);
    }

    Closure Exchange(Stream stream, Timer deadline)
    {
        while (true)
        {
            if (_isAccepted)
                deadline.Change(Timeout.Infinite, Timeout.Infinite);
            if (!TryFill(stream, _frame))
                return Closure.ByPeer;
            // Before anything else: whatever is done first would count as time on the network.
            var t2 = _clock.Now;
            if (!_rate.TryTake())
                return Closure.TooManyRequests;
            if (!SyncFrame.TryRead(_frame, out var frame, out _) || !Answer(stream, frame, t2))
                return Closure.MalformedFrame;
        }
    }

    bool Answer(Stream stream, in SyncFrame frame, ControlTime t2)
    {
        if (frame.Kind == SyncFrameKind.Token)
            return AnswerToken(stream);
        if (!_isAccepted || frame.Kind != SyncFrameKind.Request)
            return false;
        var synchronised = _clock.IsSynchronised;
        var bound = _clock.ErrorBound;
        var resolution = (uint)Math.Min(uint.MaxValue, _clock.Resolution.Ticks * 100);
        SyncFrame.Reply(frame, t2.Nanoseconds, _clock.Now.Nanoseconds, synchronised, bound, resolution).Write(_frame);
        stream.Write(_frame);
        return true;
    }

    // A server without tokens accepts any: a headset that has one still connects.
    bool AnswerToken(Stream stream)
    {
        var length = new byte[SyncToken.LengthSize];
        if (!TryFill(stream, length) || !SyncToken.TryReadLength(length, out var count))
            return false;
        var text = new byte[count];
        if (!TryFill(stream, text) || !SyncToken.TryReadText(text, out var token))
            return false;
        _isAccepted |= _options.RoleOf(token) != null;
        SyncFrame.TokenReply(_isAccepted).Write(_frame);
        stream.Write(_frame);
        return true;
    }

    void Overdue()
    {
        _isOverdue = true;
        _socket.Dispose();
    }

    Closure Explain(Exception e)
    {
        if (e is AuthenticationException)
            return Closure.TlsHandshake;
        if (e is not (IOException or SocketException or ObjectDisposedException))
            return Closure.Failure;
        if (_isOverdue)
            return _awaited;
        var socket = e as SocketException ?? e.InnerException as SocketException;
        // A receive that timed out says TimedOut on Windows, WouldBlock on Unix.
        return socket?.SocketErrorCode is SocketError.TimedOut or SocketError.WouldBlock ? Closure.Silence : Closure.ByPeer;
    }

    static bool TryFill(Stream stream, byte[] buffer) => stream.ReadAtLeast(buffer, buffer.Length, false) == buffer.Length;
}
