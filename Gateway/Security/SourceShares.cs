using System.Net;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Counts the connections of each source, which is a token and an address (<see cref="ClientNetwork"/>), to both ports, so that no source uses the
/// connections of the others. Thread-safe.
/// </summary>
/// <remarks>
/// A connection above the maximum is refused. Closing an older one instead would also end connections that are in use: their clients would connect
/// again and close the next ones.
/// </remarks>
sealed class SourceShares(GatewayOptions options)
{
    readonly Dictionary<(string Hash, IPAddress Network), int> _open = [];

    /// <summary>
    /// Counts a connection until the returned object is disposed. Clients without a token, clients of other roles and the adapters of the
    /// gateway have no maximum here.
    /// </summary>
    /// <param name="tokenHash">Hash of the connection's token; null if it connected without a token.</param>
    /// <returns>Null if the source has the maximum number of connections.</returns>
    public IDisposable TryEnter(byte[] tokenHash, Role role, IPAddress address)
    {
        if (tokenHash == null || role != Role.Source || options.IsOwnAdapter(tokenHash)) return new Place(null);
        var source = (Convert.ToHexString(tokenHash), ClientNetwork.Of(address));
        lock (_open)
        {
            var count = _open.GetValueOrDefault(source);
            if (count >= options.MaxConnectionsOfSource) return null;
            _open[source] = count + 1;
        }

        return new Place(() => Leave(source));
    }

    void Leave((string Hash, IPAddress Network) source)
    {
        lock (_open)
            if (--_open[source] == 0) _open.Remove(source);
    }

    sealed class Place(Action leave) : IDisposable
    {
        Action _leave = leave;

        public void Dispose() => Interlocked.Exchange(ref _leave, null)?.Invoke();
    }
}
