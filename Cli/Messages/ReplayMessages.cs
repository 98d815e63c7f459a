using Nowpose.Cli.Replay;

namespace Nowpose.Cli.Messages;

/// <summary>Error messages of the command <c>replay</c>, with remedies.</summary>
static class ReplayMessages
{
    public const string Interrupted = "the replay was interrupted, so the result is that of a part of the recording; run it again";

    public static string BodyTooLarge(string path) => $"{path}: the errors are too large to compute; the positions must be in m";
    public static string TooLong(string path, int max) => $"{path}: contains more than {max} numbers, which is the maximum; record shorter sessions";
    public static string JointCount(string path, int line, int joints, int header) =>
        $"{path}:{line}: field 'joints' has {joints} numbers, but the robot of the header has {header} joints; record the session again";
    public static string InSession(string path) => $"{path} is a recorded session, which contains this value; remove the option";

    public static string TooManyFrames(string path, double seconds, double hertz, double samplingMs) =>
        FormattableString.Invariant($"{path}: {seconds:G6} s is too long to replay at {hertz} frames per second and a sample every ")
        + FormattableString.Invariant($"{samplingMs:G6} ms; check that the time column is in seconds");

    public static string TooManyPhases(string path, int phases, double seconds, int max) =>
        FormattableString.Invariant($"--phases: {phases} passes over the {seconds:G6} s of {path} are too many; the maximum for this file is {max}");

    public static string OtherPredictor(string predictor) =>
        $"the session was displayed with {predictor}; repeat it with --predictor {predictor}";

    public static string CoarseRows(double intervalMs, double samplingMs, RecordingGaps? gaps = null) =>
        FormattableString.Invariant($"the rows are {intervalMs:G6} ms apart (median{(gaps is { } found ? "; " + Intervals(found) : "")}), ")
        + FormattableString.Invariant($"but a sample is taken every {samplingMs:G6} ms: samples between rows are interpolated, ")
        + "so the error of the predictors is too small; check that the time is in s, or increase --sampling-ms";

    public static string Gaps(RecordingGaps gaps) =>
        $"{Intervals(gaps)}; the motion in {(gaps.Count == 1 ? "it" : "them")} is a straight line; if the true motion was not, record it again";

    static string Intervals(RecordingGaps gaps) =>
        (gaps.Count == 1 ? "1 interval without rows is" : FormattableString.Invariant($"{gaps.Count} intervals without rows are"))
        + FormattableString.Invariant($" longer than {RecordingGaps.MinSeconds} s, the largest {gaps.LargestSeconds:0.0} s");

    public static string TooShort(double seconds, double neededSeconds) =>
        FormattableString.Invariant($"{seconds:G6} s is too short: a frame is evaluated only after sample 4 has arrived, which takes up ")
        + FormattableString.Invariant($"to {neededSeconds:G6} s; record a longer motion");

    public static string AllLost(double loss) =>
        FormattableString.Invariant($"--loss {loss}: no sample arrived, so no frame could be evaluated; use a smaller share");
    /// <param name="axis">Name of an axis whose errors are too large.</param>
    public static string TooLarge(string path, string axis) =>
        $"{path}: the errors of {axis} are too large to compute; the positions must be in rad or m";

    public static string NothingScored(int samples) =>
        $"no frame could be evaluated: a frame needs a control time between sample {samples} and the last sample of a joint, "
        + "and neither a gap between samples nor the age of the newest sample may exceed the maximum gap; record a longer session, or with a larger maximum gap";
}
