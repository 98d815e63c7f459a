using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Gateway;
using Nowpose.Sync;
using Nowpose.Web;

namespace Nowpose.Cli.Sync;

/// <summary>Writes Fig. 8 of the paper for a log of sync exchanges: an HTML page, and its data as CSV.</summary>
static class SyncPage
{
    public const string DefaultPath = "nowpose-sync.html";

    /// <param name="path">Path of the page. The data file has the same name with the extension .csv.</param>
    /// <param name="log">Path of the log, which the page names.</param>
    /// <param name="instants">Path of the instants; null without them. Neither input is overwritten.</param>
    /// <exception cref="InputException">The page cannot be written.</exception>
    public static void Write(string path, string log, string instants, IReadOnlyList<SyncExchange> exchanges, string estimator)
    {
        var data = Path.ChangeExtension(path, ".csv");
        // The unpacked log can be beside the compressed one.
        OptionPath.RequireNoInput("--page", [path, data], [log, instants, .. new[] { log, instants }.Select(Unpacked).Where(File.Exists)]);
        if (path == data) throw new InputException(SyncPageTexts.WouldOverwritePage(path));
        var steps = SyncSteps.Of(exchanges, estimator);
        var figure = SyncFigure.Of(steps, SyncClaims.Of(steps), SyncPageTexts.Conditions(exchanges.Count, steps.Count))
            with
        { FileName = Path.GetFileName(data) };
        string[][] conditions =
        [
            ["Log", Path.GetFileName(log)],
            ["Exchanges", FormattableString.Invariant($"{steps.Count} in {(steps.Count == 0 ? 0 : steps[^1].Seconds):0.0} s")],
            ["Estimator", estimator == ClockEstimators.Ransac ? SyncPageTexts.Ransac : estimator],
        ];
        OptionPath.Write("--page", path, () =>
        {
            OutputFile.Write(path, Pages.Figures.Render(FiguresJson.Of(
                SyncPageTexts.Title, SyncPageTexts.Subtitle, conditions, missing: [], [figure])));
            OutputFile.Write(data, figure.Table.WriteCsv);
        });
    }

    static string Unpacked(string path) => path?.EndsWith(".gz", StringComparison.OrdinalIgnoreCase) == true ? path[..^".gz".Length] : null;
}
