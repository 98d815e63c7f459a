using System.Diagnostics;

namespace Nowpose.Gateway.Status;

/// <summary>Times from a joint state's receipt until a subscriber's socket accepts it: in total, and over the last half minute to minute.</summary>
/// <remarks>Thread-safe. Messages that a client throttles are not counted, because their wait is intended.</remarks>
public sealed class ForwardingTimes(TimeProvider time = null)
{
    static readonly TimeSpan Window = TimeSpan.FromSeconds(30);

    /// <summary>Upper bounds of the classes counted since the start, s; the last class has none.</summary>
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

    /// <summary>Gets the count of each class; one more than <see cref="Limits"/>.</summary>
    internal long[] Counts() => [.. Enumerable.Range(0, _counts.Length).Select(i => Interlocked.Read(ref _counts[i]))];

    /// <param name="receivedAt">A count of <see cref="Stopwatch"/>.</param>
    public void Add(long receivedAt) => Add(Stopwatch.GetElapsedTime(receivedAt));

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

    /// <summary>Gets a percentile over the last half minute to minute; null if nothing was forwarded.</summary>
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
            // A time that is being added concurrently may be lost or counted late: one in millions.
            var old = _before;
            _before = _now;
            old.Clear();
            if (elapsed >= Window + Window) _before.Clear();
            Volatile.Write(ref _now, old);
            Volatile.Write(ref _turned, _time.GetTimestamp());
        }
    }
}
