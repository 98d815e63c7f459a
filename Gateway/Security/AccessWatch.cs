namespace Nowpose.Gateway.Security;

/// <summary>Checks the tokens of all connections periodically, and ends a connection whose token is no longer valid. Thread-safe.</summary>
/// <remarks>
/// The check also reads changed files of tokens, headsets and certificate, so that errors in them are logged even if no client connects.
/// </remarks>
sealed class AccessWatch : IDisposable
{
    internal static readonly TimeSpan Interval = TimeSpan.FromMilliseconds(500);

    /// <summary>
    /// Maximum number of connections of one paired headset to both ports. It uses two; the others may be lost ones that the gateway has not closed yet.
    /// </summary>
    const int MaxOfHeadset = 16;

    readonly GatewayOptions _options;
    // In the order in which they began.
    readonly LinkedList<Watched> _watched = [];
    readonly PeriodicTask _look;

    public AccessWatch(GatewayOptions options, Action<string> log)
    {
        _options = options;
        Sources = new SourceShares(options);
        _look = new PeriodicTask(Follow, Interval, AccessMessages.NotChecked, log, TimeProvider.System);
    }

    public SourceShares Sources { get; }

    /// <summary>Number of watched connections.</summary>
    public int Count
    {
        get
        {
            lock (_watched) return _watched.Count;
        }
    }

    /// <summary>Starts the periodic check. The first check is immediate.</summary>
    public void Start()
    {
        _look.RunUnlessBusy();
        _look.Start();
    }

    /// <summary>
    /// Watches a connection until the returned object is disposed. At the maximum of a paired headset, the connection replaces the oldest one.
    /// </summary>
    /// <param name="tokenHash">Hash of the connection's token; null if it connected without a token.</param>
    /// <param name="role">Role of the connection.</param>
    /// <param name="end">Called once, with the reason, when the connection must end; must not block.</param>
    /// <param name="lasts">
    /// Returns whether the browser session is still valid; null for a connection that sent the token itself. Must not block.
    /// </param>
    public IDisposable Watch(byte[] tokenHash, Role role, Action<Closure> end, Func<bool> lasts = null)
    {
        var isHeadset = tokenHash != null && _options.Headsets?.Contains(tokenHash) == true;
        var watched = new Watched(this, tokenHash, role, end, lasts);
        Watched[] replaced = [];
        lock (_watched)
        {
            _watched.AddLast(watched);
            if (isHeadset) replaced = [.. _watched.Where(watched.HasSameToken).SkipLast(MaxOfHeadset)];
        }

        foreach (var old in replaced) old.End(Closure.ConnectionLimit);
        return watched;
    }

    /// <summary>Ends the periodic check, and waits for the present one.</summary>
    public void Dispose()
    {
        _look.Dispose();
        _look.Exclude(() => { });
    }

    void Follow()
    {
        _options.Follow();
        Watched[] present;
        lock (_watched)
            present = [.. _watched];
        foreach (var watched in present.Where(watched => !watched.Holds))
        {
            watched.End(Closure.Token);
        }
    }

    sealed class Watched(AccessWatch watch, byte[] tokenHash, Role role, Action<Closure> end, Func<bool> lasts) : IDisposable
    {
        byte[] TokenHash => tokenHash;

        public bool Holds => watch._options.Holds(tokenHash, role) && lasts?.Invoke() != false;

        public bool HasSameToken(Watched other) => tokenHash.AsSpan().SequenceEqual(other.TokenHash);

        public void End(Closure why)
        {
            if (Remove()) end(why);
        }

        public void Dispose() => Remove();

        bool Remove()
        {
            lock (watch._watched) return watch._watched.Remove(this);
        }
    }
}
