namespace Nowpose.Cli.Replay;

/// <summary>The long intervals without rows during the motion of a recording. The replay interpolates them linearly.</summary>
/// <param name="Count">Number of these intervals.</param>
/// <param name="LargestSeconds">Length of the largest one.</param>
readonly record struct RecordingGaps(int Count, double LargestSeconds)
{
    /// <summary>Minimum length of an interval, s.</summary>
    public const double MinSeconds = 0.5;

    /// <summary>Minimum ratio to the median interval. Recordings with a low rate have long intervals everywhere.</summary>
    const double MinRatio = 2;

    /// <summary>Minimum number of rows. A file with fewer rows contains the corners of a motion.</summary>
    const int MinRows = 51;

    /// <summary>Finds the gaps of a motion; null if there are none.</summary>
    /// <param name="times">Times of the rows, increasing, s.</param>
    /// <param name="interval">The median interval between them, s.</param>
    /// <param name="changesAt">Whether the values of a row differ from those of the row before it. If they do not, the interval is a rest.</param>
    public static RecordingGaps? Of(IReadOnlyList<double> times, double interval, Func<int, bool> changesAt)
    {
        if (times.Count < MinRows) return null;
        var min = Math.Max(MinSeconds, MinRatio * interval);
        double[] gaps = [.. Enumerable.Range(1, times.Count - 1)
            .Where(row => times[row] - times[row - 1] > min && changesAt(row))
            .Select(row => times[row] - times[row - 1])];
        return gaps.Length == 0 ? null : new RecordingGaps(gaps.Length, gaps.Max());
    }
}
