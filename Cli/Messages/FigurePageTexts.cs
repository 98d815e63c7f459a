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

    public const string MotionValue =
        "500 mm forward and back, 1000 mm/s, 5000 mm/s², 50 000 mm/s³ (Figs 13 and 14: --limits), 0.4 s dwell; we chose the limits, "
        + "because the paper states none";

    public static string Runs(int phases, int clockRuns, string clockSeconds) =>
        $"{phases} with random phases of sampling and frames; clock: {clockRuns} runs of {clockSeconds} s each";

    public const string FurtherPredictor = ", compared with the paper's in Figs 13 and 14 in addition to adaptive and gp";
    public const string Rms = "RMS over all frames of all runs; ratio: divided by the RMS of hold, the newest sample that has arrived";
    public const string VirtualTime = "virtual time, the same on every machine";
}
