using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Security;

/// <summary>Checks the tokens of all connections periodically, and ends a connection whose token is no longer valid. Thread-safe.</summary>
/// <remarks>
/// The check also reads changed files of tokens, headsets and certificate, so that errors in them are logged even if no client connects.
/// </remarks>
sealed class AccessWatch : IDisposable
{
    internal static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(500);

    readonly GatewayOptions _options;
    readonly HashSet<Watched> _watched = [];
    readonly Action<string> _log;
    readonly ExpiryNotice _expiry;
    readonly Timer _timer;

    public AccessWatch(GatewayOptions options, Action<string> log)
    {
        _options = options;
        _log = log;
        _expiry = new ExpiryNotice(log);
        _timer = new Timer(_ => Look());
    }

    /// <summary>Number of watched connections.</summary>
    public int Count
    {
        get
        {
            lock (_watched) return _watched.Count;
        }
    }

    /// <summary>Starts the periodic check. The first check is immediate.</summary>
    public void Start() => _timer.Change(TimeSpan.Zero, Timeout.InfiniteTimeSpan);

    /// <summary>Watches a connection until the returned object is disposed.</summary>
    /// <param name="tokenHash">Hash of the connection's token; null if it connected without a token.</param>
    /// <param name="role">Role of the connection.</param>
    /// <param name="end">Called once when the token is no longer valid; must not block.</param>
    /// <param name="lasts">
    /// Returns whether the browser session is still valid; null for a connection that sent the token itself. Must not block.
    /// </param>
    public IDisposable Watch(byte[] tokenHash, Role role, Action end, Func<bool> lasts = null)
    {
        var watched = new Watched(this, tokenHash, role, end, lasts);
        lock (_watched)
            _watched.Add(watched);
        return watched;
    }

    public void Dispose()
    {
        using var stopped = new ManualResetEvent(false);
        if (_timer.Dispose(stopped)) stopped.WaitOne();
    }

    void Look()
    {
        try
        {
            Follow();
        }
        catch (Exception e)
        {
            // Catches all exceptions, because an unhandled exception on a timer's thread ends the process.
            _log(AccessMessages.NotChecked(e.GetType().Name, e.Message));
        }

        try
        {
            _timer.Change(Interval, Timeout.InfiniteTimeSpan);
        }
        catch (ObjectDisposedException)
        {
            // The watch was disposed in the meantime.
        }
    }

    void Follow()
    {
        _options.Follow();
        _expiry.Look(_options.Certificate?.NotAfter, DateTime.Now);
        Watched[] present;
        lock (_watched)
            present = [.. _watched];
        foreach (var watched in present.Where(watched => !watched.Holds))
        {
            watched.Dispose();
            watched.End();
        }
    }

    sealed class Watched(AccessWatch watch, byte[] tokenHash, Role role, Action end, Func<bool> lasts) : IDisposable
    {
        public bool Holds => watch._options.Holds(tokenHash, role) && lasts?.Invoke() != false;

        public void End() => end();

        public void Dispose()
        {
            lock (watch._watched)
                watch._watched.Remove(this);
        }
    }
}
