using System.CommandLine;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;
using Nowpose.Gateway.Options;
using Spectre.Console;

namespace Nowpose.Cli.Figures;

/// <summary><c>figures</c>: recomputes the paper's figures as CSV data and one HTML page.</summary>
static class FiguresVerb
{
    public static Command Create()
    {
        var output = TextOption.Create("--out", "Folder for figures.html and one CSV per figure", standard: "nowpose-figures");
        var quick = SwitchOption.Create("--quick", "Compute a quarter of the runs, in less than a minute and with slightly less accurate results");
        var seed = NumberOption.Create("--seed", "Seed of the random numbers", FigureSettings.Full.Seed, 0, 1_000_000, "");
        var limits = MotionLimits.Option();
        var predictor = PredictorOption.Create(FigurePageTexts.FurtherPredictor, standard: null);
        var pictures = TextOption.Create("--pictures", "Folder for the plots that the manual shows, as SVG");
        var open = Browser.Option();
        var verb = new Command("figures", "Recompute the paper's figures: data as CSV, and one HTML page with the paper's claims beside our results.")
        {
            output, quick, seed, limits, predictor, pictures, open,
        };
        FigureSettings SettingsOf(ParseResult parsed) => (parsed.GetValue(quick) ? FigureSettings.Quick : FigureSettings.Full) with
        {
            Seed = parsed.GetValue(seed),
            Limits = parsed.GetValue(limits),
            Ours = FigureSettings.With(parsed.GetValue(predictor)),
        };
        // Runs on a separate thread, so that Ctrl-C can request a partial result and wait for it.
        verb.SetAction((parsed, cancel) => Task.Run(
            () => Run(SettingsOf(parsed), parsed.GetValue(output), parsed.GetValue(pictures), cancel, parsed.GetValue(open)),
            CancellationToken.None));
        return verb;
    }

    /// <param name="pictures">Folder for the pictures; null to write none.</param>
    /// <param name="opens">Whether to open the page in a browser.</param>
    internal static int Run(FigureSettings settings, string folder, string pictures, CancellationToken cancel, bool opens = false)
    {
        var output = FiguresOutput.At(folder, pictures);
        var run = new FigureRun(FigureSet.Studies(settings, cancel));
        IReadOnlyList<Figure> figures = null;
        ConsoleProgress.Run("computing", "studies", run.Total, report => figures = run.Run(report, cancel));
        output.Write(figures, settings);
        Print(figures, output);
        if (settings.Limits != MotionLimits.Default)
            Console.Out.WriteLine(FigurePageTexts.OtherLimits(settings.Limits.Text, MotionLimits.Default.Text));
        if (opens) Browser.OpenOrExplain(output.PagePath);
        return cancel.IsCancellationRequested ? ExitStatus.Interrupted : ExitStatus.Done;
    }

    static void Print(IReadOnlyList<Figure> figures, FiguresOutput output)
    {
        var table = new Table().AddColumns("figure", FigurePageTexts.ClaimColumn, "file");
        foreach (var figure in figures)
            table.AddRow(Markup.Escape($"{figure.Number}  {figure.Title}"), figure.Verdict.Words(), figure.FileName);
        ResultConsole.Create().Write(table);
        Console.Out.WriteLine(output.PagePath);
        foreach (var picture in output.PicturePaths) Console.Out.WriteLine(picture);
    }
}
