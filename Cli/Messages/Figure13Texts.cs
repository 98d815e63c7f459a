namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 13.</summary>
static class Figure13Texts
{
    public const string OverSampling = "Interpolating polynomials for different sampling intervals";

    public const string OverSamplingClaim =
        "Over large parts of the range of T_s the quadratic predicts best, and the cubic is more sensitive to a longer T_s.";

    public const string QuadraticBest = "The quadratic is the best of the three at every T_s of 50 ms or more.";
    public const string QuadraticBestBelow = "The quadratic is also the best below 50 ms. (The paper does not claim this.)";

    public static string CubicBetter(string values) => $"the cubic is better at {values}";

    public const string CubicGrows = "From 20 to 100 ms the cubic's error grows more than the quadratic's.";
    public const string OverLatency = "Interpolating polynomials for different latencies";
    public const string OverLatencyClaim = "At every latency, the most accurate predictions are those of the quadratic and the cubic.";
    public const string OverLatencyError = "Interpolating polynomials with an error in the latency";

    public const string OverLatencyErrorClaim =
        "At every error in the latency, the most accurate predictions are those of the quadratic and the cubic.";

    public const string Within20Ms = "at each error up to ±20 ms";
    public const string Within50Ms = "at each error up to ±50 ms";
    public const string OverSamplingError = "Interpolating polynomials with an error in the time stamps";
    public const string OverSamplingErrorClaim = "The quadratic and the cubic are sensitive to errors of the assumed t_k.";
    public const string LineBest = "With a time stamp error of ±10 ms, the line is the best of the three.";

    public static string BestIsCurved(string where) => $"The best of the three is the quadratic or the cubic {where}.";
    public static string LineBetter(string values) => $"the line is better than both at {values}";

    public const string IsSo = "it is";

    public static string WorseAt(string values) => $"worse at {values}";

    public const string CubicBeatsLine = "The cubic is also better than the line at each latency.";

    public static string Reacts(string predictor, string factor) =>
        $"A time stamp error of ±5 ms multiplies the {predictor}'s RMS error by {factor} or more.";
}
