namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 8.</summary>
static class Figure08Texts
{
    public static string Beyond(string defaultUs, string share, string paperUs) =>
        $"On the same exchanges, the default estimator is within {defaultUs} µs 95 % of the time, {share} of the paper's {paperUs} µs.";

    public static string Conditions(int runs, string seconds, string exchangeErrors) =>
        $"Simulated good WiFi, an exchange every 200 ms, {runs} runs of {seconds} s with skews of 5 to 80 ppm that vary by ±2 ppm; plots "
        + $"and file show the first run. RANSAC over 100 exchanges with 20 hypotheses, moving average of 20.{exchangeErrors}";

    public static string OffsetSummary(string seconds) => $"Offset error from {seconds} s on, all runs";

    public const string SkewColumn = "Skew error at the end (ppm)";
    public const string OffsetCriterion = "From 10 s on, the true error of the offset is always below 1 ms.";
    public const string SkewCriterion = "The skew error over the last quarter of the run is less than half of the error from 2 to 10 s.";

    public const string RoundTripCriterion =
        "In the quarter with the shortest round trips, P95 of the error is less than half of P95 in the quarter with the longest ones.";

    public const string OffsetPlot = "Error of the offset";
    public const string SkewPlot = "Skew of all estimators";
    public const string FittingError = "From 10 s on, the fitting error |ε_i| of Eq. (6) is below 1 ms for at least 95 % of all exchanges.";

    public static string ExchangeErrors(string share, double boundMs) =>
        $" With the true offset instead of the fit, {share} of the exchanges from 10 s on have an error below {boundMs} ms; the others took at "
        + "least 2 ms longer in one direction than in the other.";

    public const string SkewConverges =
        "The skew converges: in the last quarter it varies less than half as much as from 2 to 10 s (RMS about the mean of the last "
        + "quarter), and from the third quarter to the last its mean changes by less than a quarter of the variation from 2 to 10 s.";

    public const string ShortRoundTrips =
        "In the quarter with the shortest round trips, P95 of |ε| is less than half of P95 in the quarter with the longest ones.";

    public static string TooFewExchanges(int exchanges, int min) => $"{exchanges} usable exchanges after 10 s; {min} are needed";

    public const string LateSkew = "the skew was first estimated after 10 s";
    public const string NoExchange = "no usable exchange in the third quarter";

    public static string SkewMeasured(string early, string last, string change) =>
        $"{early} ppm, then {last} ppm; change of the mean {change} ppm";

    public const string Claim =
        "As exchanges come in, offset and skew converge and the fitting error becomes less than 1 ms; the round-trip time shows how "
        + "accurate an exchange was.";

    public static string BeyondAxis(string title, int beyond, int all) =>
        FormattableString.Invariant($"{title} ({beyond} of {all} values beyond the axis)");

    public const string RelativeOffset = "Offset Φ*, relative to the first offset";
    public const string FirstOffset = "Θ₂, the offset at the first exchange";
}
