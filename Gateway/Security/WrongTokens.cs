using System.Net;
using System.Net.Sockets;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Counts the wrong tokens and codes of each IPv4 address and each IPv6 network (/64), and blocks an address with too many until the minute
/// is over. Thread-safe.
/// </summary>
/// <remarks>
/// 128 bits cannot be guessed at any rate. Log-in and pairing refuse a blocked address, which limits the rate of guesses. Bearer and sync tokens
/// are always compared, because clients with valid tokens may have the same address: only the answers to wrong ones are delayed. A client that
/// closes the delayed connections and opens new ones is not limited in its guesses. The delay reduces log output and load.
/// </remarks>
sealed class WrongTokens(TimeProvider time)
{
    /// <summary>Maximum number of addresses. Beyond it, the one without an attempt for the longest time is removed.</summary>
    internal const int MaxAddresses = 1000;

    /// <summary>Maximum number of delayed answers of one address that wait one after the other.</summary>
    internal const int MaxTurns = 10;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Lock _lock = new();
    readonly Dictionary<IPAddress, LinkedListNode<Address>> _addresses = [];
    // Sorted by their last attempt, the oldest first.
    readonly LinkedList<Address> _order = [];

    /// <summary>Gets the remaining time for which an address is blocked; zero if it is not.</summary>
    public TimeSpan BlockedFor(IPAddress address)
    {
        lock (_lock) return Find(address) is { } known ? BlockedFor(known) : TimeSpan.Zero;
    }

    public void Count(IPAddress address) => Count(address, TimeSpan.Zero);

    /// <summary>
    /// Counts a wrong token. Returns the delay of its answer: answers to an address that was blocked are sent one by one, a delay apart.
    /// </summary>
    /// <remarks>
    /// An address gets one refusal per delay, for any number of connections. Answers beyond <see cref="MaxTurns"/> wait with the last one.
    /// </remarks>
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

    // Moves the address to the end, because it has just made an attempt. Null for an address without wrong tokens.
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

    // A machine can have any number of IPv6 addresses, but only one /64 network.
    static IPAddress Key(IPAddress address)
    {
        if (address == null) return IPAddress.None;
        if (address.IsIPv4MappedToIPv6) return address.MapToIPv4();
        return address.AddressFamily == AddressFamily.InterNetworkV6 ? new IPAddress([.. address.GetAddressBytes().AsSpan(0, 8), .. new byte[8]]) : address;
    }

    sealed class Address(IPAddress key)
    {
        public IPAddress Key => key;

        // Number of wrong tokens, and the time of the first of them.
        public int Count;
        public long Since;

        // Delay of the last delayed answer, and the time from which it counts.
        public TimeSpan Waiting;
        public long WaitingAt;
    }
}
