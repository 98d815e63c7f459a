using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Security;

/// <summary>Ends connections whose token is no longer valid. Thread-safe.</summary>
/// <remarks>The check also updates the lists and the certificate from their files, and reports errors when no clients connect.</remarks>
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

    /// <summary>Number of connections that end when their token is revoked.</summary>
    public int Count
    {
        get
        {
            lock (_watched) return _watched.Count;
        }
    }

    /// <summary>Starts the periodic check, with the first one immediately.</summary>
    public void Start() => _timer.Change(TimeSpan.Zero, Timeout.InfiniteTimeSpan);

    /// <param name="tokenHash">Hash of the connection's token; null if none was needed.</param>
    /// <param name="role">Role of the connection.</param>
    /// <param name="end">
    /// Called once when the token is no longer valid, unless the returned object was disposed before; must not wait.
    /// </param>
    /// <param name="lasts">Checks whether the browser session is still valid; null for a connection with the token itself. Must not wait.</param>
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
            // Catches all exceptions: an unhandled one on a timer's thread ends the process with every connection.
            _log(AccessMessages.NotChecked(e.GetType().Name, e.Message));
        }

        try
        {
            _timer.Change(Interval, Timeout.InfiniteTimeSpan);
        }
        catch (ObjectDisposedException)
        {
            // Already disposed.
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
