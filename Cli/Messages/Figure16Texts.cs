namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 16.</summary>
static class Figure16Texts
{
    public const string Title = "Swing of the first axis: true, uncompensated, compensated";

    public const string Claim =
        "The compensated signal follows the true one, while the uncompensated one lags behind; only the curved phases of the profile are "
        + "hard to predict.";

    public static string Beyond(string curved, string steady, string quadraticCurved, string quadraticSteady) =>
        $"The error of adaptive is {curved} where the velocity changes within a section and {steady} where it does not; the error of the "
        + $"quadratic is {quadraticCurved} and {quadraticSteady}.";

    public const string Summary = "Tool error over the whole swing, all runs";

    public static string Conditions(string radiusMm, string speed) =>
        $"youBot, first axis forward and back by a quarter turn, arm extended: the tool moves on a circle of {radiusMm} mm radius at up to "
        + $"{speed} mm/s. We chose the stroke and the limits, because the paper states none. Four shorter moves precede this move, and no move repeats. "
        + "The whole chain: samples every 50 ms, stamped in the control system and sent 55 to 105 ms later over simulated WiFi; the clock by "
        + "RANSAC (100 exchanges, 20 hypotheses, moving average of 20); L_visu (true value 40 ms) from pictures of the simulated display. L is "
        + "100 to 150 ms. The plots show the forward move of the first run; the numbers include all runs.";

    public const string FollowsCriterion =
        "The RMS error of the compensated signal is less than half of that of the uncompensated one, including the overshoot after each stop.";

    public const string CurvedCriterion =
        "Where the velocity changes within the 250 ms that a section spans, the RMS error of the compensated signal is at least 1.5 times as large "
        + "as where the velocity does not change.";

    public const string DistancePlot = "Distance on the circle";
    public const string DistanceAxis = "distance on the circle";
    public const string FirstMove = "first move of the run";
}
