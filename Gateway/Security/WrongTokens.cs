using System.Net;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Counts the wrong tokens and codes from each address (<see cref="ClientNetwork"/>) per minute, and blocks an address with too many until the minute
/// is over. Thread-safe.
/// </summary>
/// <remarks>
/// Login and pairing refuse a blocked address, which limits the rate of guesses. Bearer and sync tokens are compared even from a blocked
/// address, because clients with valid tokens may have the same address; only the responses to wrong tokens are delayed. The delay reduces log
/// output and load. It does not limit the guesses of a client that opens many connections, but a token of 128 bits cannot be guessed at any
/// rate.
/// </remarks>
sealed class WrongTokens(TimeProvider time)
{
    /// <summary>Maximum number of addresses. At the limit, a new address replaces the one whose last attempt is the oldest.</summary>
    internal const int MaxAddresses = 1000;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Lock _lock = new();
    readonly Dictionary<IPAddress, LinkedListNode<Address>> _addresses = [];
    // Sorted by the time of the last attempt, the oldest first.
    readonly LinkedList<Address> _order = [];

    /// <summary>Gets the remaining time for which an address is blocked; zero if it is not blocked.</summary>
    public TimeSpan BlockedFor(IPAddress address)
    {
        lock (_lock) return Find(address) is { } known ? BlockedFor(known) : TimeSpan.Zero;
    }

    /// <summary>Counts a wrong token. Returns whether its address was already blocked.</summary>
    public bool Count(IPAddress address)
    {
        lock (_lock)
        {
            var one = Find(address) ?? Add(ClientNetwork.Of(address));
            var isBlocked = BlockedFor(one) > TimeSpan.Zero;
            if (one.Count == 0 || time.GetElapsedTime(one.Since) >= Span) (one.Since, one.Count) = (time.GetTimestamp(), 0);
            one.Count++;
            return isBlocked;
        }
    }

    TimeSpan BlockedFor(Address one)
    {
        if (one.Count < PairingLimits.WrongCodesPerMinute) return TimeSpan.Zero;
        var left = Span - time.GetElapsedTime(one.Since);
        return left > TimeSpan.Zero ? left : TimeSpan.Zero;
    }

    // Finds the entry of an address, and moves it to the end of the list. Returns null for an address without wrong tokens.
    Address Find(IPAddress address)
    {
        if (!_addresses.TryGetValue(ClientNetwork.Of(address), out var node)) return null;
        _order.Remove(node);
        _order.AddLast(node);
        return node.Value;
    }

    Address Add(IPAddress key)
    {
        if (_addresses.Count >= MaxAddresses)
        {
            _addresses.Remove(_order.First.Value.Key);
            _order.RemoveFirst();
        }

        return (_addresses[key] = _order.AddLast(new Address(key))).Value;
    }

    sealed class Address(IPAddress key)
    {
        public IPAddress Key => key;

        // Count: number of wrong tokens. Since: time of the first of them.
        public int Count;
        public long Since;
    }
}
