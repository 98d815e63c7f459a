using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The pictures of a series that could be read, sorted by control time.</summary>
/// <remarks>
/// Codes repeat after 65.5 s. If the pictures are in the order in which they were taken, or in its reverse, the order determines the
/// period of each picture. Otherwise, all pictures count as taken within one period. For a series shorter than half a period, the result
/// does not depend on the order.
/// </remarks>
sealed class TimeOrder
{
    /// <summary>
    /// Minimum share of the steps between consecutive pictures that have the same direction in time. With at least this share, the given order
    /// counts as the order in which the pictures were taken, or its reverse.
    /// </summary>
    const double MinShareInOrder = 0.9;

    TimeOrder(IReadOnlyList<PictureResult> pictures, bool isGivenOrder) => (Pictures, IsGivenOrder) = (pictures, isGivenOrder);

    /// <summary>The pictures in increasing order of control time.</summary>
    public IReadOnlyList<PictureResult> Pictures { get; }

    /// <summary>Whether the given order was the order in which the pictures were taken, or its reverse.</summary>
    public bool IsGivenOrder { get; }

    /// <param name="pictures">Pictures in any order. Those that were not read are ignored.</param>
    public static TimeOrder Of(IEnumerable<PictureResult> pictures)
    {
        PictureResult[] read = [.. pictures.Where(picture => picture.IsRead)];
        double[] intervals = [.. read.Skip(1).Select((picture, i) => PictureResult.IntervalMs(read[i], picture))];
        int forward = intervals.Count(ms => ms >= 0), backward = intervals.Count(ms => ms <= 0);
        var isGivenOrder = Math.Max(forward, backward) >= MinShareInOrder * intervals.Length;
        double[] times = isGivenOrder ? Summed(read.Length, intervals) : WithinPeriod([.. read.Select(picture => picture.LedMs)]);
        // Equal times are sorted by name, so that the result does not depend on the given order.
        return new TimeOrder([.. read.Zip(times).OrderBy(each => each.Second).ThenBy(each => each.First.File, StringComparer.Ordinal).Select(each => each.First)], isGivenOrder);
    }

    static double[] Summed(int count, double[] intervals)
    {
        var times = new double[count];
        for (var i = 1; i < count; i++) times[i] = times[i - 1] + intervals[i - 1];
        return times;
    }

    /// <summary>Gets the times relative to the end of the longest interval without a picture.</summary>
    static double[] WithinPeriod(double[] ledMs)
    {
        double[] sorted = [.. ledMs.Order()];
        var start = Enumerable.Range(0, sorted.Length)
            .MaxBy(i => i > 0 ? sorted[i] - sorted[i - 1] : sorted[0] - sorted[^1] + TimestampCode.PeriodMs);
        return [.. ledMs.Select(ms => ms >= sorted[start] ? ms - sorted[start] : ms - sorted[start] + TimestampCode.PeriodMs)];
    }
}
