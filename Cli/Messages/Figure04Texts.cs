namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 4.</summary>
static class Figure04Texts
{
    public const string Title = "Error as a function of velocity and latency";

    public const string Claim =
        "At constant velocity v, a latency L causes the error e = v·L. At the usual speeds up to 1000 mm/s and latencies of 30 to 250 ms, "
        + "the errors are significant.";

    public const string Conditions =
        "Constant velocities. With a sample every 0.5 ms, the latency is L alone. With T_s of 50 ms, a sample is also T_s/2 old on average, so "
        + "the points for 50 ms are farther right. With prediction, the remaining error is v times the clock error (P95 of Fig. 8).";

    public static string HoldCriterion(string tolerance) => $"The error of hold is v·L within {tolerance}, at each velocity and latency.";

    public const string MinCriterion = "At 1000 mm/s and 30 ms, the error of hold is 10 mm or more.";

    public static string MinMeasured(string min, string max) => $"{min}, up to {max} at 250 ms";

    public static string Beyond(string predicted, string left) =>
        $"With exact clocks, the largest errors that remain at constant velocity are: {predicted}. At 1000 mm/s, the P95 of the errors "
        + $"from the clock estimators is: {left}.";

    public const string HoldAt50Ms = "hold, a sample every 50 ms";
    public const string HoldEveryFrame = "hold, a sample in every frame";
}
