using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Replay;

/// <summary>Compares the interval between the rows of a recorded motion with the sampling interval.</summary>
static class RowInterval
{
    /// <summary>Maximum ratio of the two intervals without a warning. Recorded time stamps scatter and are rounded.</summary>
    const double MaxRatio = 1.1;

    /// <summary>Gets the median interval between times, s.</summary>
    /// <param name="times">Two times or more, increasing, s.</param>
    public static double Of(IReadOnlyList<double> times) => Quantile.Of(times.Zip(times.Skip(1), (from, to) => to - from), 0.5);

    /// <summary>
    /// Gets the warning that samples are interpolated between the rows of a motion, because the rows are too far apart or because some
    /// intervals are long; null if the rows are dense enough.
    /// </summary>
    public static string WarningOf(MotionRecording motion, double samplingMs) =>
        WarningOf(motion.Times, motion.ChangesAt, samplingMs);

    /// <param name="times">Times of the rows, two or more, increasing, s.</param>
    /// <param name="changesAt">Whether the values of a row differ from those of the row before it.</param>
    /// <inheritdoc cref="WarningOf(MotionRecording, double)"/>
    public static string WarningOf(IReadOnlyList<double> times, Func<int, bool> changesAt, double samplingMs)
    {
        var interval = Of(times);
        var gaps = RecordingGaps.Of(times, interval, changesAt);
        if (1e3 * interval > MaxRatio * samplingMs) return ReplayMessages.CoarseRows(1e3 * interval, samplingMs, gaps);
        return gaps is { } found ? ReplayMessages.Gaps(found) : null;
    }
}
