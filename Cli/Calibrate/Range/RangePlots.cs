using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Creates plots like Figs 10 and 11 of the paper. All pictures must have a render time.</summary>
static class RangePlots
{
    public static readonly FigureColumn Render = new("render time", "ms"), Visu = new("L_visu", "ms"), Picture = new("picture"),
        Load = new("vertices", "million");

    static readonly FigureColumn Time = new("time", "ms");

    /// <summary>Fig. 10: render time and L_visu, picture by picture.</summary>
    public static FigurePlot OverPictures(string title, IReadOnlyList<MeasuredPicture> pictures)
    {
        double[] x = [.. Enumerable.Range(1, pictures.Count).Select(i => (double)i)];
        return new FigurePlot(title, Picture, Time,
        [
            new("render time", Looks.Hold, x, [.. pictures.Select(each => each.RenderMs)]),
            new("L_visu", Looks.Adaptive, x, [.. pictures.Select(each => (double?)each.VisuMs)]),
        ])
        { FromZero = true, Marks = [.. LoadMarks(pictures)] };
    }

    /// <summary>Fig. 11a: median and middle 68 % at each load. Includes only pictures whose load is known.</summary>
    public static (FigurePlot Plot, FigureTable Table) OverLoad(IEnumerable<MeasuredPicture> pictures)
    {
        var table = new FigureTable(Load, Render, new("render time deviation", "ms"), Visu, new("L_visu deviation", "ms"), new("pictures"));
        foreach (var load in pictures.Where(each => each.Vertices.HasValue).GroupBy(each => each.Vertices.Value).OrderBy(group => group.Key))
        {
            var (render, renderDeviation) = Middle.Of(load.Select(each => each.RenderMs.Value));
            var (visu, visuDeviation) = Middle.Of(load.Select(each => each.VisuMs));
            table.Add(load.Key / 1e6, render, renderDeviation, visu, visuDeviation, load.Count());
        }
        PlotTrace Middles(string label, string look, int column) => table.Trace(label, look, 0, column) with
        {
            Marked = true,
            Deviation = [.. table.Rows.Select(row => row[column + 1])],
        };
        var traces = new[] { Middles("render time", Looks.Hold, 1), Middles("L_visu", Looks.Adaptive, 3) };
        return (new FigurePlot("Over the load", Load, Time, traces) { FromZero = true }, table);
    }

    /// <summary>Fig. 11b: L_visu against render time for each picture, with the constant-latency range.</summary>
    /// <param name="fit">The fit, or null if there is none.</param>
    public static FigurePlot OverRenderTime(IEnumerable<MeasuredPicture> pictures, RangeFitResult fit)
    {
        var sorted = pictures.OrderBy(each => each.RenderMs).ToArray();
        PlotTrace[] range = fit == null
            ? []
            : [new("L_visu of the profile", Looks.Quadratic, [sorted[0].RenderMs.Value, fit.ValidToRenderMs], [fit.VisuMs, fit.VisuMs])];
        var points = PlotTrace.Points("pictures", Looks.Adaptive, sorted.Select(each => (each.RenderMs.Value, each.VisuMs)));
        return new FigurePlot("Over render time", Render, Visu, [points, .. range])
        {
            FromZero = true, Marks = fit?.LimitRenderMs is double limit ? [new(FormattableString.Invariant($"limit {limit:0.##} ms"), limit)] : [],
        };
    }

    static IEnumerable<PlotMark> LoadMarks(IReadOnlyList<MeasuredPicture> pictures)
    {
        const int MaxLabels = 6, RoundLoad = 500_000;
        var loads = pictures.Select(each => each.Vertices).Distinct().Count();
        if (loads == 1) yield break;
        for (var i = 0; i < pictures.Count; i++)
        {
            if (pictures[i].Vertices is not int vertices || i > 0 && pictures[i - 1].Vertices == vertices) continue;
            // More labels would overlap.
            if (loads <= MaxLabels || vertices % RoundLoad == 0) yield return new(FormattableString.Invariant($"{vertices / 1e6:0.##} M"), i + 1);
        }
    }
}
