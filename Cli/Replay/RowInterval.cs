using Nowpose.Cli.Messages;
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

    /// <summary>Gets the warnings of a replay, about rows that are too far apart, and about gaps.</summary>
    public static IEnumerable<string> WarningsOf(MotionRecording motion, double samplingMs) =>
        new[] { WarningOf(motion, samplingMs), RecordingGaps.WarningOf(motion) }.Where(warning => warning != null);

    /// <summary>Gets the warning that samples are interpolated between rows of a motion; null if the rows are dense enough.</summary>
    public static string WarningOf(MotionRecording motion, double samplingMs) => WarningOf(Of(motion.Times), samplingMs);

    /// <param name="interval">Median interval between rows, s.</param>
    /// <inheritdoc cref="WarningOf(MotionRecording, double)"/>
    public static string WarningOf(double interval, double samplingMs) =>
        1e3 * interval > MaxRatio * samplingMs ? ReplayMessages.CoarseRows(1e3 * interval, samplingMs) : null;
}
