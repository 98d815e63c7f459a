using System.Net;
using System.Net.Sockets;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Security;

/// <summary>
/// Counts the wrong tokens and codes of each IPv4 address and each IPv6 network (/64), and blocks an address with too many until the minute
/// is over. Thread-safe.
/// </summary>
/// <remarks>
/// Log-in and pairing refuse a blocked address. Bearer and sync tokens may come from a headset behind the same address as a client that guesses.
/// A token of <see cref="TokenStrength.MinBits"/> cannot be guessed at any rate, so it is always compared, and only the answer to a wrong one is
/// delayed. A weaker token can be guessed: an address may try <see cref="MaxWeakGuesses"/> wrong ones, and then one per
/// <see cref="WeakGuessInterval"/>, over any number of connections. Others are refused without a comparison.
/// </remarks>
sealed class WrongTokens(TimeProvider time)
{
    /// <summary>Maximum number of addresses. Beyond it, the one without an attempt for the longest time is removed.</summary>
    internal const int MaxAddresses = 1000;

    /// <summary>Maximum number of delayed answers of one address that wait one after the other.</summary>
    internal const int MaxTurns = 10;

    /// <summary>Number of wrong weak tokens of one address that are compared without a pause between them.</summary>
    internal const int MaxWeakGuesses = 60;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    /// <summary>Interval at which an address may try one more weak token: as many per minute as wrong pairing codes.</summary>
    internal static readonly TimeSpan WeakGuessInterval = Span / PairingLimits.WrongCodesPerMinute;

    readonly Lock _lock = new();
    readonly long _start = time.GetTimestamp();
    readonly Dictionary<IPAddress, LinkedListNode<Address>> _addresses = [];
    // Sorted by their last attempt, the oldest first.
    readonly LinkedList<Address> _order = [];

    TimeSpan Now => time.GetElapsedTime(_start);

    /// <summary>Gets the remaining time for which an address is blocked; zero if it is not.</summary>
    public TimeSpan BlockedFor(IPAddress address)
    {
        lock (_lock) return Find(address) is { } known ? BlockedFor(known) : TimeSpan.Zero;
    }

    /// <summary>Gets the role of a token; null if it is wrong, or weak and not compared because its address has guessed too often.</summary>
    /// <param name="compare">Returns the role of a token; null for a wrong one.</param>
    public Role? RoleOf(IPAddress address, string token, Func<string, Role?> compare)
    {
        if (TokenStrength.BitsOf(token) >= TokenStrength.MinBits) return compare(token);
        // Compared under the lock, so that parallel guesses are limited as well.
        lock (_lock)
        {
            var known = Find(address);
            if (known != null && UntilGuess(known) > TimeSpan.Zero) return null;
            if (compare(token) is { } role) return role;
            known ??= Add(Key(address));
            known.RefilledAt = (known.RefilledAt > Now ? known.RefilledAt : Now) + WeakGuessInterval;
            return null;
        }
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
        var untilReset = one.Count < PairingLimits.WrongCodesPerMinute ? TimeSpan.Zero : Span - time.GetElapsedTime(one.Since);
        var left = UntilGuess(one) > untilReset ? UntilGuess(one) : untilReset;
        return left > TimeSpan.Zero ? left : TimeSpan.Zero;
    }

    // Time until the address may try a weak token; negative or zero if it may.
    TimeSpan UntilGuess(Address one) => one.RefilledAt - ((MaxWeakGuesses - 1) * WeakGuessInterval) - Now;

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

        // Time at which all guesses of weak tokens are available again.
        public TimeSpan RefilledAt;
    }
}
