namespace Nowpose.Cli.Messages;

/// <summary>Titles, labels and sentences of the page of the command <c>calibrate sine</c>.</summary>
static class SinePageTexts
{
    public const string Tracking = "following robot and hologram";
    public const string Title = "Latency of a jog back and forth";

    public static string VisuResult(double visuMs, double deviationMs, double totalMs) =>
        FormattableString.Invariant($"L_visu is {visuMs:0.0} ms ± {deviationMs:0.0} ms; the total lag is {totalMs:0.0} ms.");

    public static string LagResult(double totalMs, double deviationMs) =>
        FormattableString.Invariant($"The hologram is {totalMs:0.0} ms ± {deviationMs:0.0} ms behind the robot.");

    public const string MotionsNote =
        "Each curve is scaled to its own range. Shifted forward by the lag, the hologram's curve agrees with the robot's.";

    public const string ShiftedHologram = "hologram, shifted by the lag";
    public const string Correlation = "Correlation as a function of the lag";

    public const string CorrelationNote =
        "The peak is at the total latency. A least-squares fit of the robot's position and speed locates it more finely than the camera's frame interval.";

    public static string Compensated(double usedMs) =>
        FormattableString.Invariant($"compensated: the remaining lag is the error of the latency of {usedMs:0.##} ms that the headset used");

    public static string NotCompensated(double applicationMs, double halfSamplingMs) =>
        FormattableString.Invariant($"not compensated: L_app {applicationMs:0.##} ms and half of T_s, {halfSamplingMs:0.##} ms, are subtracted");

    public const string PeriodLabel = "Period of the jog";

    public static string Period(double? seconds) => seconds is double known
        ? FormattableString.Invariant($"{known:0.0} s in the recording; if this is not the period of your jog, the times of the recording are wrong")
        : "longer than the recording";

    public const string TotalOnly = "the total latency only";
}
