namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 14.</summary>
static class Figure14Texts
{
    public const string OverSampling = "Approximating quadratics for different sampling intervals";
    public const string OverLatency = "Approximating quadratics for different latencies";
    public const string OverLatencyError = "Approximating quadratics with an error in the latency";
    public const string AnyLatencyError = "For any error in the latency";
    public const string OverSamplingError = "Approximating quadratics with an error in the time stamps";
    public const string OverSamplingErrorClaim = "A longer history makes the quadratic far more robust against errors of the assumed t_k.";
    public const string LongerIsBetter = "With a time stamp error of ±10 ms, h = 4 is better than h = 3, and h = 3 is better than h = 2.";
    public const string HalfTheError =
        "From 0 to ±10 ms, the factor by which the error grows is less than half as large with h = 3 and with h = 4 as with h = 2.";

    public const string Never = "at none of the errors";
    public static string From(string ms) => $"from ±{ms} ms";

    /// <param name="three">Errors at which h = 3 is better than h = 2, for example "from ±4 ms".</param>
    /// <param name="four">Errors at which h = 4 is better than h = 3.</param>
    public static string Growth(string growth, string three, string four) =>
        $"{growth}; h = 3 is better than h = 2 {three}, and h = 4 is better than h = 3 {four}";

    public static string LongerIsWorse(string where) => $"{where} a longer history predicts less accurately, as long as t_k is exact.";

    public const string ThreeIsWorse = "h = 3 is less accurate than h = 2";
    public const string FourIsWorse = "h = 4 is less accurate than h = 3";
}
