namespace Nowpose.Cli.Messages;

/// <summary>Results of the command <c>recommend</c>, and the reasons for them.</summary>
static class RecommendTexts
{
    public static string Recording(string file, double seconds, double intervalMs, string spread, double repeatPercent) =>
        FormattableString.Invariant($"{file}: {seconds:0.0} s, a sample every {intervalMs:0.0} ms ({spread}), {repeatPercent:0.0} % repeated");

    public const string ReductionNote = "reduction: share of the error without prediction that the predictor removes";

    public static string Reduction(string reduction, string first, string second) =>
        $"It removes {reduction} of the error ({first} and {second} in the two halves).";

    public static string Blend(double ms, double defaultMs, string share, string first, string second) =>
        FormattableString.Invariant($"Use a blend of {ms:0} ms. A blend of {defaultMs} ms increases the RMS error by {share} ({first} and ")
        + FormattableString.Invariant($"{second} in the two halves), and removes the jumps between predictions.");

    public static string Condition(double samplingMs, double? latencyMs) =>
        FormattableString.Invariant($"a sample every {samplingMs:0.###} ms, {latencyMs:0.###} ms late");

    public const string AsRecorded = "samples, latencies and frames as recorded";

    public static string SmallerError(double? percent, string predictor, string first, string second) =>
        FormattableString.Invariant($"its error is {percent:0} % smaller than that of {predictor} ({first} and {second} in the two halves)");

    public const string NoneBetter = "no other predictor has a smaller error";

    public static string EquallyGood(string predictor) => $"{predictor} is equally good: it is better on one half and worse on the other";

    public static string LittleBetter(string predictor, double percent) =>
        FormattableString.Invariant($"the error of {predictor} is smaller, but by at most {percent:0} %");
}
