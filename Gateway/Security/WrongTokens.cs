using System.Net;
using System.Net.Sockets;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Security;

/// <summary>Counts the wrong tokens and codes of each IPv4 address and each IPv6 network (/64), and blocks an address with too many until the minute is over. Any thread.</summary>
/// <remarks>128 bits are not guessed at any rate. The limit slows the guessing of weaker tokens, and keeps log and processor quiet.</remarks>
sealed class WrongTokens(TimeProvider time)
{
    /// <summary>Maximum number of addresses. All counts are reset beyond it.</summary>
    const int MaxAddresses = 1000;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Dictionary<IPAddress, (long Since, int Count)> _counts = [];

    public bool IsBlocked(IPAddress address) => BlockedFor(address) > TimeSpan.Zero;

    /// <summary>How long an address is still blocked; zero for one that is not.</summary>
    public TimeSpan BlockedFor(IPAddress address)
    {
        lock (_counts)
        {
            if (!_counts.TryGetValue(Key(address), out var wrong) || wrong.Count < PairingLimits.WrongCodesPerMinute) return TimeSpan.Zero;
            var left = Span - time.GetElapsedTime(wrong.Since);
            return left > TimeSpan.Zero ? left : TimeSpan.Zero;
        }
    }

    public void Count(IPAddress address)
    {
        var key = Key(address);
        lock (_counts)
        {
            if (_counts.Count >= MaxAddresses && !_counts.ContainsKey(key)) _counts.Clear();
            var isRecent = _counts.TryGetValue(key, out var wrong) && time.GetElapsedTime(wrong.Since) < Span;
            _counts[key] = isRecent ? (wrong.Since, wrong.Count + 1) : (time.GetTimestamp(), 1);
        }
    }

    // A machine has as many IPv6 addresses as it likes, but one /64 network.
    static IPAddress Key(IPAddress address)
    {
        if (address == null) return IPAddress.None;
        if (address.IsIPv4MappedToIPv6) return address.MapToIPv4();
        return address.AddressFamily == AddressFamily.InterNetworkV6 ? new IPAddress([.. address.GetAddressBytes().AsSpan(0, 8), .. new byte[8]]) : address;
    }
}
