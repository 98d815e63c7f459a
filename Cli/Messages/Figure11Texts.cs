namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 11.</summary>
static class Figure11Texts
{
    public const string AboveLimit =
        "Between the limit and a refresh interval, most frames of this display are exactly one refresh late, and few are in time. Above a "
        + "refresh interval, the time from a frame's start to the next refresh varies, and L_visu scatters over a whole refresh interval.";

    public const string OverLoad = "Render time and L_visu as a function of the load";
    public const string OverLoadClaim = "L_visu is approximately constant up to a certain number of vertices; beyond it, L_visu scatters.";
    public const string OverRenderTime = "L_visu as a function of the render time";

    public const string OverRenderTimeClaim =
        "As a function of the render time, the constant-latency range is independent of the absolute count of vertices. The L_visu inside it can be "
        + "stored; render times outside it show large variances and are less suitable for compensation.";

    public static string Beyond(string limitMs, string above) =>
        $"The end of the range is the most likely boundary between good and bad pictures; the display's own limit is {limitMs} ms. At run "
        + $"time, the median of 15 frames is compared with the end of the range. {above}";

    public const string MedianCriterion = "At loads whose render time stays below the limit, the median of L_visu is the same within 1 ms.";

    public static string MedianMeasured(string ms, string millions) => $"within {ms} ms up to {millions} million";

    public const string AtLoads = "At the loads whose render time is beyond the limit, about the mean of each load,";

    public static string SameLimit(string share) => $"A scene whose vertices take twice as long to render has the same limit within {share}.";
    public static string Stored(double ms) => $"Inside the range, 95 % of the pictures have the stored L_visu within {ms} ms.";

    public const string AtRenderTimes = "At render times above the limit, in steps of 1 ms and about the mean of each step,";

    public static string Deviation(string where, double factor) =>
        $"{where} the standard deviation of L_visu is at least {factor} times as large as within the range; both are computed from the middle 95 %.";

    public static string Spread(string where, string share, string intervalMs) =>
        $"{where} the middle 95 % of L_visu extend over at least {share} of a refresh interval, {intervalMs} ms.";

    public const string NoPictureBeyond = "no picture beyond the range";
    public const string NoScatterWithin = "no scatter within the range";

    public static string Measured(string togetherMs, string withinMs) => $"{togetherMs} ms; within the range {withinMs} ms";
    public static string Step(string fromMs) => $"{fromMs} ms and more";
    public static string IndividuallyTooSmall(string measured, string groups) => $"{measured}; individually too small: {groups}";
}
