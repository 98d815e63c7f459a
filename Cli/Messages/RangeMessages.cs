namespace Nowpose.Cli.Messages;

/// <summary>Error messages and warnings about the constant-latency range, with remedies.</summary>
static class RangeMessages
{
    public static string TooFewPairs(int pairs, int min) => $"pairs: {pairs} are too few to determine a range; take at least {min} pictures";

    public const string NoPlateau = "pairs: L_visu is not the same at the lowest render times, so no range exists; "
        + "measure again from a lower load, with headset and camera on a stand";

    public static string Scatters(double spreadMs, double maxMs) =>
        FormattableString.Invariant($"pairs: L_visu scatters by {spreadMs:0.0} ms at the lowest render times, so no range exists; up to ")
        + FormattableString.Invariant($"{maxMs} ms are allowed; measure again from a lower load, with headset and camera on a stand");

    public const string NoLimit =
        "limit not reached: beyond the longest measured render time, the headset reports the range as unknown; extend the sweep to a higher load";

    public static string LimitBetween(double? usedMs, double openMs) =>
        FormattableString.Invariant($"the limit is between {usedMs:0.00} ms, which is used, and {openMs:0.00} ms: sweep in finer steps ")
        + "around it";

    public static string SourceDoesNotRespond(string file, string source, double lowMs, double highMs) =>
        FormattableString.Invariant($"{file}: this source does not respond to load: {source} was {lowMs:0.00} ms at the lowest loads and ")
        + FormattableString.Invariant($"{highMs:0.00} ms at the highest; repeat the sweep with another source of the render time, or run ")
        + "calibrate vlc for L_visu without a limit";
}
