using System.Net;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Counts, for each address, the connections that have not yet shown whether they may be: no single address takes all places by
/// connecting and saying nothing. Any thread.
/// </summary>
sealed class Newcomers(int greatest)
{
    readonly Dictionary<IPAddress, int> _counts = [];

    /// <returns>To be disposed when the connection was let in, or is gone; null when there are too many from that address.</returns>
    public IDisposable TryEnter(EndPoint remote)
    {
        // From who knows where: all of these are one.
        var address = (remote as IPEndPoint)?.Address ?? IPAddress.None;
        lock (_counts)
        {
            var count = _counts.GetValueOrDefault(address);
            if (count >= greatest) return null;
            _counts[address] = count + 1;
        }

        return new Place(this, address);
    }

    void Leave(IPAddress address)
    {
        lock (_counts)
        {
            if (--_counts[address] == 0) _counts.Remove(address);
        }
    }

    sealed class Place(Newcomers all, IPAddress address) : IDisposable
    {
        int _hasLeft;

        public void Dispose()
        {
            if (Interlocked.Exchange(ref _hasLeft, 1) == 0) all.Leave(address);
        }
    }
}
