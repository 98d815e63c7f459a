namespace Nowpose.Cli.Messages;

/// <summary>Text of the page of the command <c>sync</c>.</summary>
static class SyncPageTexts
{
    public static string WouldOverwritePage(string page) =>
        $"--page: {page}: the data file of the page would have the same name; use a name that ends in .html";

    public const string Ransac = "RANSAC, as in the paper";
    public const string Title = "Clock synchronisation from your log";
    public const string Subtitle = "Fig. 8 of the paper from recorded exchanges.";

    /// <param name="logged">Number of exchanges in the log.</param>
    /// <param name="used">Number of valid exchanges.</param>
    public static string Conditions(int logged, int used) =>
        "t starts at the first exchange, and the offsets are relative to its offset. Θ₂ is the offset at t = 0. "
        + "The true offset is unknown, so errors are relative to the fit. RTT includes the time at the server, as in the paper."
        + (used == logged ? "" : FormattableString.Invariant($" {logged - used} of {logged} exchanges are invalid and left out."));
}
