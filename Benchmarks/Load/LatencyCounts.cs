namespace Nowpose.Benchmarks.Load;

/// <summary>Histogram of latencies with classes of 10 µs. Latencies above 1 s are in the last class. Thread-safe; adding does not allocate.</summary>
sealed class LatencyCounts
{
    const long StepNs = 10_000;
    const int Steps = 100_000;

    readonly long[] _counts = new long[Steps + 1];
    long _maximumNs;

    public long Total => _counts.Sum();

    public TimeSpan Maximum => new(Interlocked.Read(ref _maximumNs) / 100);

    public void Add(long nanoseconds)
    {
        Interlocked.Increment(ref _counts[Math.Clamp(nanoseconds / StepNs, 0, Steps)]);
        for (var seen = Interlocked.Read(ref _maximumNs); nanoseconds > seen;)
        {
            var before = Interlocked.CompareExchange(ref _maximumNs, nanoseconds, seen);
            if (before == seen) break;
            seen = before;
        }
    }

    /// <summary>Gets the latency that a share of all latencies does not exceed; zero if there are none.</summary>
    public TimeSpan Quantile(double share)
    {
        var left = (long)Math.Ceiling(share * Total);
        for (var step = 0; step < _counts.Length; step++)
        {
            left -= _counts[step];
            if (left <= 0) return new TimeSpan((step + 1) * StepNs / 100);
        }

        return Maximum;
    }

    public void Clear()
    {
        Array.Clear(_counts);
        Interlocked.Exchange(ref _maximumNs, 0);
    }
}
