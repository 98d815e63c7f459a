using Nowpose.Cli.Figures;
using Nowpose.Cli.Figures.Clocks;
using Nowpose.Sync;
using Nowpose.Web;

namespace Nowpose.Cli.Sync;

/// <summary>Writes Fig. 8 of the paper for a log of sync exchanges: an HTML page, and its data as CSV.</summary>
static class SyncPage
{
    public const string DefaultPath = "nowpose-sync.html";

    /// <param name="path">Path of the page. The data file has the same name with the extension .csv.</param>
    /// <param name="log">Path of the log, which the page names.</param>
    /// <exception cref="InputException">The page cannot be written.</exception>
    public static void Write(string path, string log, IReadOnlyList<SyncExchange> exchanges, string estimator)
    {
        var data = Path.ChangeExtension(path, ".csv");
        if (new[] { path, data }.Any(written => Path.GetFullPath(written) == Path.GetFullPath(log)))
            throw new InputException($"--page: {path}: the page or its data, {data}, would overwrite the log; use another name");
        if (path == data) throw new InputException($"--page: {path}: the page's data would overwrite it; use a name that ends in .html");
        var steps = SyncSteps.Of(exchanges, estimator);
        var figure = SyncFigure.Of(steps, SyncClaims.Of(steps), Conditions(exchanges.Count, steps.Count))
            with
        { FileName = Path.GetFileName(data) };
        string[][] conditions =
        [
            ["Log", Path.GetFileName(log)],
            ["Exchanges", FormattableString.Invariant($"{steps.Count} in {(steps.Count == 0 ? 0 : steps[^1].Seconds):0.0} s")],
            ["Estimator", estimator == ClockEstimators.Ransac ? "RANSAC, as in the paper" : estimator],
        ];
        OutputPath.File("--page", path, () =>
        {
            File.WriteAllText(path, FiguresPage.Render(FiguresJson.Of(
                "Clock synchronisation of your log", "Fig. 8 of the paper from recorded exchanges.", conditions, missing: [], [figure])));
            using var file = File.CreateText(data);
            figure.Table.WriteCsv(file);
        });
    }

    static string Conditions(int logged, int used) => "t and the offsets count from the first exchange. Θ₂ is the offset at t = 0. "
        + "The true offset is unknown, so errors are relative to the fit. RTT includes the time at the server, as in the paper."
        + (used == logged ? "" : FormattableString.Invariant($" {logged - used} of {logged} exchanges are invalid and left out."));
}
