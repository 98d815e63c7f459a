using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The read pictures of a series in the order of their control time, with that time relative to one of them.</summary>
/// <remarks>
/// Codes repeat after 65.5 s. The given order shows the period of each picture if it is the camera's order, or its reverse. In any other
/// order, all pictures count as taken within one period. The result is the same for all orders of a series that is shorter than half a
/// period.
/// </remarks>
sealed class TimeOrder
{
    /// <summary>Minimum share of neighbours with the same direction of time in a series that is in the camera's order, or in the reverse.</summary>
    const double MinShareInOrder = 0.9;

    TimeOrder(IReadOnlyList<(PictureResult Picture, double Ms)> pictures, bool isGivenOrder) => (Pictures, IsGivenOrder) = (pictures, isGivenOrder);

    /// <summary>The pictures, the earliest first, and their control time, ms.</summary>
    public IReadOnlyList<(PictureResult Picture, double Ms)> Pictures { get; }

    /// <summary>Whether the given order was that of the camera, or the reverse.</summary>
    public bool IsGivenOrder { get; }

    /// <param name="pictures">In any order; those that were not read are left out.</param>
    public static TimeOrder Of(IEnumerable<PictureResult> pictures)
    {
        PictureResult[] read = [.. pictures.Where(picture => picture.IsRead)];
        double[] intervals = [.. read.Skip(1).Select((picture, i) => PictureResult.IntervalMs(read[i], picture))];
        int forward = intervals.Count(ms => ms >= 0), backward = intervals.Count(ms => ms <= 0);
        var isGivenOrder = Math.Max(forward, backward) >= MinShareInOrder * intervals.Length;
        double[] times = isGivenOrder ? Summed(read.Length, intervals) : WithinPeriod([.. read.Select(picture => picture.LedMs)]);
        // The names decide between equal times, so that the order does not depend on the given one.
        return new TimeOrder([.. read.Zip(times).OrderBy(each => each.Second).ThenBy(each => each.First.File, StringComparer.Ordinal)], isGivenOrder);
    }

    static double[] Summed(int count, double[] intervals)
    {
        var times = new double[count];
        for (var i = 1; i < count; i++) times[i] = times[i - 1] + intervals[i - 1];
        return times;
    }

    /// <summary>Gets times from the end of the longest interval without a picture.</summary>
    static double[] WithinPeriod(double[] ledMs)
    {
        double[] sorted = [.. ledMs.Order()];
        var start = Enumerable.Range(0, sorted.Length)
            .MaxBy(i => i > 0 ? sorted[i] - sorted[i - 1] : sorted[0] - sorted[^1] + TimestampCode.PeriodMs);
        return [.. ledMs.Select(ms => ms >= sorted[start] ? ms - sorted[start] : ms - sorted[start] + TimestampCode.PeriodMs)];
    }
}
