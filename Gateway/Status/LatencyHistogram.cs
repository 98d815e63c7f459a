using System.Numerics;

namespace Nowpose.Gateway.Status;

/// <summary>
/// A histogram of durations whose classes are at most 6 % wide. Uses constant memory. Thread-safe; adding a duration does not block.
/// </summary>
sealed class LatencyHistogram
{
    const int ClassesPerOctaveBits = 4;
    const int ClassesPerOctave = 1 << ClassesPerOctaveBits;

    // Below 2^4 ticks, classes are one tick wide. The last class starts at 31 · 2^25 ticks (104 s) and contains all longer durations.
    const int Classes = (31 - ClassesPerOctaveBits) * ClassesPerOctave;

    readonly long[] _counts = new long[Classes];

    public void Add(TimeSpan length) => Interlocked.Increment(ref _counts[ClassOf(length.Ticks)]);

    public void Clear()
    {
        for (var i = 0; i < Classes; i++) Interlocked.Exchange(ref _counts[i], 0);
    }

    /// <summary>
    /// Gets a percentile of the durations in two histograms, at most one class width too long; null if both histograms are empty.
    /// </summary>
    public static TimeSpan? Percentile(LatencyHistogram a, LatencyHistogram b, double fraction)
    {
        var all = 0L;
        for (var i = 0; i < Classes; i++) all += Interlocked.Read(ref a._counts[i]) + Interlocked.Read(ref b._counts[i]);
        if (all == 0) return null;
        var left = Math.Max(1, (long)Math.Ceiling(all * fraction));
        for (var i = 0; i < Classes; i++)
        {
            left -= Interlocked.Read(ref a._counts[i]) + Interlocked.Read(ref b._counts[i]);
            if (left <= 0) return new TimeSpan(EndOf(i));
        }

        return new TimeSpan(EndOf(Classes - 1));
    }

    static int ClassOf(long ticks)
    {
        if (ticks < ClassesPerOctave) return (int)Math.Max(0, ticks);
        var octave = BitOperations.Log2((ulong)ticks) - ClassesPerOctaveBits;
        return Math.Min(Classes - 1, octave * ClassesPerOctave + (int)(ticks >> octave));
    }

    // Returns the exclusive upper bound of a class.
    static long EndOf(int index)
    {
        if (index < ClassesPerOctave) return index + 1;
        var octave = index / ClassesPerOctave - 1;
        return (long)(ClassesPerOctave + index % ClassesPerOctave + 1) << octave;
    }
}
