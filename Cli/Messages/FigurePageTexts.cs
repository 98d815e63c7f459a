namespace Nowpose.Cli.Messages;

/// <summary>Text of the page and the table of figures.</summary>
static class FigurePageTexts
{
    public const string ClaimColumn = "claim of the paper";
    public const string Title = "The paper's figures, recomputed";

    public const string Subtitle =
        "Latency and sampling compensation in mixed-reality-in-the-loop simulations of production systems, Schnierle & Röck 2022: the "
        + "paper's claims beside the results of Nowpose's classes.";

    public const string MovesOfOneDrive = "moves of one drive";
    public const string GentleMoves = "gentle pick and place";
    public const string Latency = "Latency L, from t_k to the display time";
    public const string Motion = "Motion of Figs 12 to 14";

    public static string MotionValue(string limits, string sweepLimits) =>
        $"500 mm forward and back, {(sweepLimits == limits ? limits : $"Fig. 12: {limits}, Figs 13 and 14: {sweepLimits} (option --limits)")}, "
        + "0.4 s dwell; we chose the limits, because the paper states none";

    public static string Limits(double velocity, double acceleration, double jerk) =>
        FormattableString.Invariant($"{velocity:G6} mm/s, {acceleration:G6} mm/s², {jerk:G6} mm/s³");

    public static string OtherLimits(string limits, string standard) =>
        $"Figs 13 and 14 use other limits than the default: {limits} instead of {standard}.";

    public static string Runs(int phases, int clockRuns, string clockSeconds) =>
        $"{phases} with random phases of sampling and frames; clock: {clockRuns} runs of {clockSeconds} s each";

    public const string FurtherPredictor = ", compared with the paper's in Figs 13 and 14 in addition to adaptive and gp";
    public const string Rms = "RMS over all frames of all runs; ratio: divided by the RMS of hold, the newest sample that has arrived";
    public const string VirtualTime = "virtual time, the same on every machine";
}
