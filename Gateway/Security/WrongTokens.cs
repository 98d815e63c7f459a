using System.Net;
using System.Net.Sockets;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Security;

/// <summary>Counts the wrong tokens and codes of each IPv4 address and each IPv6 network (/64), and blocks an address with too many until the minute is over. Any thread.</summary>
/// <remarks>128 bits are not guessed at any rate. The limit slows the guessing of weaker tokens, and keeps log and processor quiet.</remarks>
sealed class WrongTokens(TimeProvider time)
{
    /// <summary>Maximum number of addresses. Beyond it, the one that has tried nothing for the longest time is forgotten.</summary>
    internal const int MaxAddresses = 1000;

    /// <summary>Maximum number of answers of one address that wait one after the other.</summary>
    internal const int MaxTurns = 10;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Lock _lock = new();
    readonly Dictionary<IPAddress, LinkedListNode<Address>> _addresses = [];
    // By their last attempt, the oldest first.
    readonly LinkedList<Address> _order = [];

    public bool IsBlocked(IPAddress address) => BlockedFor(address) > TimeSpan.Zero;

    /// <summary>How long an address is still blocked; zero for one that is not.</summary>
    public TimeSpan BlockedFor(IPAddress address)
    {
        lock (_lock) return Find(address) is { } known ? BlockedFor(known) : TimeSpan.Zero;
    }

    public void Count(IPAddress address) => Count(address, TimeSpan.Zero);

    /// <summary>Counts a wrong token. Returns how long its answer waits: those to an address that was blocked leave one by one, a delay apart.</summary>
    /// <remarks>However many connections an address opens, it gets one answer per delay; the one beyond <see cref="MaxTurns"/> waits with the last.</remarks>
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

    // Whoever is looked for has just tried something. Null for an address that has sent nothing wrong.
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

    // A machine has as many IPv6 addresses as it likes, but one /64 network.
    static IPAddress Key(IPAddress address)
    {
        if (address == null) return IPAddress.None;
        if (address.IsIPv4MappedToIPv6) return address.MapToIPv4();
        return address.AddressFamily == AddressFamily.InterNetworkV6 ? new IPAddress([.. address.GetAddressBytes().AsSpan(0, 8), .. new byte[8]]) : address;
    }

    sealed class Address(IPAddress key)
    {
        public IPAddress Key => key;

        // Wrong tokens, and when the first of them came.
        public int Count;
        public long Since;

        // How long the last answer that was held back had to wait, and from when.
        public TimeSpan Waiting;
        public long WaitingAt;
    }
}
