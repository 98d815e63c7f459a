using System.Net;
using System.Net.Sockets;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Counts the wrong tokens and codes from each IPv4 address and each IPv6 network (/64) per minute, and blocks an address with too many until
/// the minute is over. Thread-safe.
/// </summary>
/// <remarks>
/// Login and pairing refuse a blocked address, which limits the rate of guesses. Bearer and sync tokens are compared even from a blocked
/// address, because clients with valid tokens may have the same address; only the responses to wrong tokens are delayed. The delay reduces log
/// output and load. It does not limit the guesses of a client that opens new connections without waiting for the responses, but a token of
/// 128 bits cannot be guessed at any rate.
/// </remarks>
sealed class WrongTokens(TimeProvider time)
{
    /// <summary>Maximum number of addresses. At the limit, a new address replaces the one whose last attempt is the oldest.</summary>
    internal const int MaxAddresses = 1000;

    /// <summary>Maximum delay of a response, as a multiple of the delay between two responses.</summary>
    internal const int MaxTurns = 10;

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

    public void Count(IPAddress address) => Count(address, TimeSpan.Zero);

    /// <summary>
    /// Counts a wrong token. Returns the time to wait before the response: the responses to a blocked address are sent one by one, one per delay,
    /// regardless of the number of connections.
    /// </summary>
    /// <remarks>Responses beyond the first <see cref="MaxTurns"/> are sent together with the last of these.</remarks>
    /// <param name="address">Address of the client.</param>
    /// <param name="delay">Time between two responses to a blocked address.</param>
    public TimeSpan Count(IPAddress address, TimeSpan delay)
    {
        lock (_lock)
        {
            var one = Find(address) ?? Add(Key(address));
            var isBlocked = BlockedFor(one) > TimeSpan.Zero;
            if (one.Count == 0 || time.GetElapsedTime(one.Since) >= Span) (one.Since, one.Count) = (time.GetTimestamp(), 0);
            one.Count++;
            if (!isBlocked) return TimeSpan.Zero;
            var left = one.Waiting - time.GetElapsedTime(one.WaitingAt);
            var wait = delay + (left > TimeSpan.Zero ? left : TimeSpan.Zero);
            if (wait > MaxTurns * delay) wait = MaxTurns * delay;
            (one.Waiting, one.WaitingAt) = (wait, time.GetTimestamp());
            return wait;
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
        if (!_addresses.TryGetValue(Key(address), out var node)) return null;
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

    // Uses the /64 network of an IPv6 address, because a machine can have any number of addresses in its network.
    static IPAddress Key(IPAddress address)
    {
        if (address == null) return IPAddress.None;
        if (address.IsIPv4MappedToIPv6) return address.MapToIPv4();
        return address.AddressFamily == AddressFamily.InterNetworkV6 ? new IPAddress([.. address.GetAddressBytes().AsSpan(0, 8), .. new byte[8]]) : address;
    }

    sealed class Address(IPAddress key)
    {
        public IPAddress Key => key;

        // Count: number of wrong tokens. Since: time of the first of them.
        public int Count;
        public long Since;

        // Waiting: delay of the last delayed response. WaitingAt: time at which this delay began.
        public TimeSpan Waiting;
        public long WaitingAt;
    }
}
