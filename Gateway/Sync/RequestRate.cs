namespace Nowpose.Gateway.Sync;

/// <summary>Limits the number of requests within any interval of one second.</summary>
/// <param name="time">Time source; null for the system's.</param>
sealed class RequestRate(int perSecond, TimeProvider time = null)
{
    readonly TimeProvider _time = time ?? TimeProvider.System;
    readonly long[] _counts = new long[perSecond];
    long _taken;

    public bool TryTake() => TryTake(_time.GetTimestamp());

    /// <summary>Counts a request if it is within the limit.</summary>
    /// <param name="count">Time of the request, a timestamp of the time provider; must not decrease.</param>
    /// <returns>False for a request beyond the limit.</returns>
    public bool TryTake(long count)
    {
        var slot = _taken % perSecond;
        // The slot holds the time of the request that is perSecond requests earlier.
        if (_taken >= perSecond && count - _counts[slot] < _time.TimestampFrequency)
            return false;
        _counts[slot] = count;
        _taken++;
        return true;
    }
}
