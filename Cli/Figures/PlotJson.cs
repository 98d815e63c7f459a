using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures;

/// <summary>Writes plots and tables as JSON for the pages. <c>Web/src/figures/data.ts</c> declares the fields.</summary>
static class PlotJson
{
    const int Digits = 4;

    public static object Of(FigurePlot plot) => new
    {
        plot.Title,
        X = Of(plot.X),
        Y = Of(plot.Y),
        plot.FromZero,
        YRange = plot.YRange is var (from, to) ? new[] { from, to } : null,
        plot.IsoMm,
        Marks = plot.Marks.Select(m => new { m.Label, m.X }),
        Traces = plot.Traces.Select(t => new
        {
            t.Label, t.Look, X = t.X.Select(x => Math.Round(x, Digits)), Y = Rounded(t.Y), t.Stepped, t.Marked, t.Scattered,
            Deviation = t.Deviation == null ? null : Rounded(t.Deviation),
        }),
    };

    public static IEnumerable<IEnumerable<double?>> Rows(FigureTable table) => table.Rows.Select(Rounded);

    static object Of(FigureColumn column) => new { column.Name, column.Unit };

    static IEnumerable<double?> Rounded(IEnumerable<double?> values) => values.Select(value => value is double v ? Math.Round(v, Digits) : (double?)null);
}
