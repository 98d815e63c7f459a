namespace Nowpose.Gateway.Status;

/// <summary>Durations of the last seconds, with the times at which they were measured.</summary>
/// <param name="capacity">Maximum number of durations. Further ones replace the oldest.</param>
/// <param name="span">Time for which a duration is recent.</param>
sealed class RecentTimes(int capacity, TimeSpan span, TimeProvider time)
{
    readonly (long At, TimeSpan Length)[] _ring = new (long, TimeSpan)[capacity];
    int _count, _next;

    /// <param name="at">Time of the measurement, a timestamp of the time provider.</param>
    public void Add(long at, TimeSpan length)
    {
        _ring[_next] = (at, length);
        _next = (_next + 1) % capacity;
        _count = Math.Min(_count + 1, capacity);
    }

    /// <summary>Adds the durations of another object, in the order of their times.</summary>
    public void Merge(RecentTimes other)
    {
        var both = _ring.Take(_count).Concat(other._ring.Take(other._count)).OrderBy(one => one.At).TakeLast(capacity).ToArray();
        _count = _next = 0;
        foreach (var (at, length) in both) Add(at, length);
    }

    /// <summary>Copies the durations. The recent ones are selected when the result is enumerated, which needs no lock.</summary>
    public IEnumerable<(long At, TimeSpan Length)> Read(long now)
    {
        var copy = _ring[.._count];
        return copy.Where(one => time.GetElapsedTime(one.At, now) < span);
    }
}
