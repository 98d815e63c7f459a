using System.Diagnostics;

namespace Nowpose.Gateway.Sync;

/// <summary>Says when there were more requests than allowed within any one second.</summary>
sealed class RequestRate(int perSecond)
{
    readonly long[] _counts = new long[perSecond];
    long _taken;

    public bool TryTake() => TryTake(Stopwatch.GetTimestamp());

    /// <param name="count">When, in counts of <see cref="Stopwatch"/>; never decreasing.</param>
    public bool TryTake(long count)
    {
        var slot = _taken % perSecond;
        // The slot holds the request that is as many back as a second may hold.
        if (_taken >= perSecond && count - _counts[slot] < Stopwatch.Frequency)
            return false;
        _counts[slot] = count;
        _taken++;
        return true;
    }
}
