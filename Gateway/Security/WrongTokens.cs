using System.Net;
using Nowpose.Pairing;

namespace Nowpose.Gateway.Pairing;

/// <summary>Counts the wrong codes of each address: after so many in a minute it is not listened to until the minute is over. Any thread.</summary>
/// <remarks>128 bits are not guessed at any rate; it keeps the log and the processor quiet.</remarks>
sealed class WrongCodes(TimeProvider time)
{
    /// <summary>Of more addresses than this the counts begin anew: the room is not somebody else's to decide on.</summary>
    const int GreatestAddresses = 1000;

    static readonly TimeSpan Span = TimeSpan.FromMinutes(1);

    readonly Dictionary<IPAddress, (long Since, int Count)> _counts = [];

    public bool IsBlocked(IPAddress address)
    {
        lock (_counts)
            return _counts.TryGetValue(address, out var wrong) && time.GetElapsedTime(wrong.Since) < Span
                && wrong.Count >= PairingLimits.WrongCodesPerMinute;
    }

    public void Count(IPAddress address)
    {
        lock (_counts)
        {
            if (_counts.Count >= GreatestAddresses && !_counts.ContainsKey(address)) _counts.Clear();
            var isRecent = _counts.TryGetValue(address, out var wrong) && time.GetElapsedTime(wrong.Since) < Span;
            _counts[address] = isRecent ? (wrong.Since, wrong.Count + 1) : (time.GetTimestamp(), 1);
        }
    }
}
