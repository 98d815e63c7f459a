using System.Globalization;
using Nowpose.Cli.Figures.Model;
using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures;

/// <summary>Writes the data of figures.html. <c>Web/src/figures/data.ts</c> declares their fields.</summary>
static class FiguresJson
{
    public static string Of(IReadOnlyList<Figure> figures, FigureSettings settings) => Of(FigurePageTexts.Title,
        FigurePageTexts.Subtitle,
        Conditions(settings), FigureSet.Numbers.Except(figures.Select(f => f.Number)), figures);

    /// <param name="conditions">Pairs of name and value.</param>
    /// <param name="missing">Numbers of the figures that were not computed.</param>
    public static string Of(string title, string subtitle, string[][] conditions, IEnumerable<string> missing, IReadOnlyList<Figure> figures) =>
        JsonText.Of(new
        {
            Title = title,
            Subtitle = subtitle,
            Conditions = conditions,
            Missing = missing,
            Figures = figures.Select(Of),
        }, isIndented: false);

    static string[][] Conditions(FigureSettings settings) =>
    [
        ["Sampling interval T_s", Ms(settings.Study.SamplingInterval)],
        [FigurePageTexts.Latency, Ms(settings.Study.Latency)],
        ["Frames", $"{settings.Study.FrameRateHz.ToString(CultureInfo.InvariantCulture)} per second"],
        [FigurePageTexts.Motion, FigurePageTexts.MotionValue(MotionLimits.Default.Text, settings.Limits.Text)],
        ["Runs", FigurePageTexts.Runs(settings.Phases, settings.ClockRuns, Numbers.Text(settings.ClockSeconds))],
        ["Seed", settings.Seed.ToString(CultureInfo.InvariantCulture)],
        ["Errors", FigurePageTexts.Rms],
        ["Computed in", FigurePageTexts.VirtualTime],
        ["Nowpose", ProgramVersion.Text],
        ["Date", DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture)],
    ];

    static string Ms(double seconds) => (1000 * seconds).ToString("0.###", CultureInfo.InvariantCulture) + " ms";

    /// <summary>Gets the data of one figure. <c>FigureData</c> declares the fields.</summary>
    public static object Of(Figure figure) => new
    {
        figure.Number,
        figure.Title,
        figure.Claim,
        Verdict = figure.Verdict.Words(),
        Criteria = figure.Criteria.Select(c => new { c.Statement, c.IsMet, c.IsUndecided, c.Measured }),
        figure.Beyond,
        figure.Conditions,
        File = figure.FileName,
        Table = new { Columns = figure.Table.Columns.Select(c => c.Label), Rows = PlotJson.Rows(figure.Table) },
        figure.Summary,
        figure.Drawings,
        Plots = figure.Plots.Select(PlotJson.Of),
    };
}
