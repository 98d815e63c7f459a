namespace Nowpose.Cli.Messages;

/// <summary>The paper's claims as criteria of <c>demo --paper</c>, and reasons for missing results.</summary>
static class PaperClaimTexts
{
    public static string Clipped(string mean, string low, string high) => $"{mean} ({low} to {high})";

    public const string Offset = "The offset is known to within 1 ms: P95 of its true error over all frames from 10 s on.";
    public const string Skew =
        "The skew converges: its RMS error over the last quarter of the run is less than half of its RMS error from 2 to 10 s.";

    public const string RoundTrip =
        "The round-trip time shows how accurate an exchange is: P95 of the error in the quarter of the exchanges with the shortest times is "
        + "less than half of that in the quarter with the longest times.";

    public const string Follows =
        "The compensated signal follows the true one: its RMS error over the whole swing, including the overshoot after each stop, is less "
        + "than half of that of the uncompensated signal.";

    public const string CurvedPhases =
        "Only the curved phases are hard to predict: the RMS error at constant velocity is at most two thirds of the RMS error in the rest "
        + "of the motion.";

    public const string Latency =
        "The end-to-end latency L is known to within 4 ms: P95 of |ε_L|, assumed minus true display time, over all frames from 10 "
        + "s on.";

    public const string Reduction = "About 80 % of the error is removed for t < 1.5 s: 1 − RMS with / RMS without compensation; 75 % or more.";

    public const string EffectiveLatency =
        "The effective latency e/v for t < 1.5 s is less than a third of that without compensation (ratio of the medians).";

    public static string NotInAll(int measured, int repeats, string reason) => $"measured in {measured} of {repeats} repeats: {reason}";

    public static string Gap(string moment) =>
        $"At {moment} the compensation is clearly visible: the gap to the real gripper is less than half of the gap without (ratio of the "
        + "RMS over the swings).";

    public const string ClockUnknown = "the clock offset was never known";
    public const string Interrupted = "the run was interrupted";
    public const string TooShort = "the run was too short";

    public static string ClockKnownFrom(double seconds) => FormattableString.Invariant($"the clock offset was known only from {seconds:0.0} s on");

    public static string NoSwing(double seconds, double pauseSeconds, double maxSeconds) =>
        FormattableString.Invariant($"no swing after {seconds:0} s has all its frames; the longest pause between frames was ")
        + FormattableString.Invariant($"{pauseSeconds:0.00} s (maximum: {maxSeconds} s)");
}
