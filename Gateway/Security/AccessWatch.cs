namespace Nowpose.Gateway.Security;

/// <summary>Ends connections whose token counts no longer. Any thread.</summary>
/// <remarks>Looking also makes the lists and the certificate follow their files, and tell what is wrong with them, while nobody connects.</remarks>
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

    /// <summary>Connections that end with their token.</summary>
    public int Count
    {
        get
        {
            lock (_watched) return _watched.Count;
        }
    }

    /// <summary>Looks now, and from now on.</summary>
    public void Start() => _timer.Change(TimeSpan.Zero, Timeout.InfiniteTimeSpan);

    /// <param name="tokenHash">Of the token that let somebody in; null for one that needed none.</param>
    /// <param name="role">As what.</param>
    /// <param name="end">Called once when the token counts no longer, unless what is returned was disposed before; must not wait.</param>
    /// <param name="lasts">Whether what the token was exchanged for still counts; null where it was shown itself. Must not wait.</param>
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
            // All of them: what leaves a timer's thread ends the process, and every connection.
            _log($"security: tokens and certificate could not be looked at ({e.GetType().Name}: {e.Message})");
        }

        try
        {
            _timer.Change(Interval, Timeout.InfiniteTimeSpan);
        }
        catch (ObjectDisposedException)
        {
            // Disposed meanwhile.
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
