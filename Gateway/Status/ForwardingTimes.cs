namespace Nowpose.Gateway.Status;

/// <summary>
/// Times from the receipt of a joint state until a subscriber's socket accepts it: counts since the start, and percentiles over a window of 30
/// to 60 s.
/// </summary>
/// <remarks>Thread-safe. Does not include throttled subscriptions, whose messages wait on purpose.</remarks>
public sealed class ForwardingTimes(TimeProvider time = null)
{
    static readonly TimeSpan Window = TimeSpan.FromSeconds(30);

    /// <summary>Upper bounds of the histogram's buckets, s. The last bucket has no upper bound.</summary>
    internal static readonly double[] Limits = [0.0001, 0.00025, 0.0005, 0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1];

    readonly TimeProvider _time = time ?? TimeProvider.System;
    readonly long[] _counts = new long[Limits.Length + 1];
    long _ticks;
    readonly Lock _turning = new();
    LatencyHistogram _now = new();
    LatencyHistogram _before = new();
    long _turned = (time ?? TimeProvider.System).GetTimestamp();

    /// <summary>Sum of all times since the start, s.</summary>
    internal double Sum => Interlocked.Read(ref _ticks) / (double)TimeSpan.TicksPerSecond;

    /// <summary>Gets the count of each bucket. The array has one element more than <see cref="Limits"/>.</summary>
    internal long[] Counts() => [.. Enumerable.Range(0, _counts.Length).Select(i => Interlocked.Read(ref _counts[i]))];

    /// <summary>Adds a message that was just sent.</summary>
    /// <param name="receivedAt">Time at which the message was received, a timestamp of the time provider.</param>
    public void Add(long receivedAt) => Add(_time.GetElapsedTime(receivedAt));

    internal void Add(TimeSpan length)
    {
        Turn();
        var seconds = length.TotalSeconds;
        var index = 0;
        while (index < Limits.Length && seconds > Limits[index]) index++;
        Interlocked.Increment(ref _counts[index]);
        Interlocked.Add(ref _ticks, length.Ticks);
        Volatile.Read(ref _now).Add(length);
    }

    /// <summary>Gets a percentile over the last 30 to 60 s; null if no joint state was forwarded in this time.</summary>
    /// <param name="fraction">0 to 1; 0.5 is the median.</param>
    public TimeSpan? Percentile(double fraction)
    {
        Turn();
        lock (_turning) return LatencyHistogram.Percentile(_now, _before, fraction);
    }

    void Turn()
    {
        if (_time.GetElapsedTime(Volatile.Read(ref _turned)) < Window) return;
        lock (_turning)
        {
            var elapsed = _time.GetElapsedTime(_turned);
            if (elapsed < Window) return;
            // Accepts that a time added at the same instant may be lost or counted late, which is rare.
            var old = _before;
            _before = _now;
            old.Clear();
            if (elapsed >= Window + Window) _before.Clear();
            Volatile.Write(ref _now, old);
            Volatile.Write(ref _turned, _time.GetTimestamp());
        }
    }
}
