namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 18.</summary>
static class Figure18Texts
{
    public const string Title = "Operating points without and with compensation";

    public const string Claim =
        "Compensation reduces the effective latency without slowing the robot: the errors of the operating points are about 80 % smaller "
        + "for t < 1500 ms.";

    public static string Beyond(string adaptive, string quadratic, string latencyMs) =>
        $"adaptive removes {adaptive} of the error, the quadratic {quadratic}. The median effective latency with adaptive is {latencyMs} ms.";

    public const string Conditions =
        "The first 1500 ms of Fig. 16; the plot shows the first run, the numbers include all. A point with the error e and the velocity v "
        + "is drawn at the latency e/v; points slower than 5 % of the maximum velocity are left out.";

    public const string Summary = "Tool error for t < 1500 ms, all runs";
    public const string ReductionCriterion = "75 % or more of the error is removed (RMS; about 80 % in the paper).";
    public const string LatencyCriterion = "The median effective latency is less than a third of that without compensation.";

    public static string LatencyMeasured(string heldMs, string predictedMs) => $"{heldMs} ms without, {predictedMs} ms with";
}
