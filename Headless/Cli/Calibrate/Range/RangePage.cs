using Nowpose.Cli.Calibrate.Page;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>The paper's Figs 10 and 11 of a set of pictures.</summary>
static class RangePage
{
    static readonly FigureColumn Render = new("render time", "ms"), Visu = new("L_visu", "ms"), Picture = new("picture"), Load = new("vertices", "million");

    public static IEnumerable<CalibrationSection> Sections(IReadOnlyList<MeasuredPicture> pictures, RangeFitResult fit)
    {
        var measured = pictures.Where(each => each.RenderMs.HasValue).ToArray();
        if (measured.Length == 0) yield break;
        yield return OverPictures(measured);
        if (measured.Any(each => each.Vertices.HasValue)) yield return OverLoad(measured);
        yield return OverRenderTime(measured, fit);
    }

    // Each load as the paper draws it, one beside the other; without loads all in one.
    static CalibrationSection OverPictures(MeasuredPicture[] pictures)
    {
        double[] x = [.. Enumerable.Range(1, pictures.Length).Select(i => (double)i)];
        var plot = new FigurePlot("Over pictures", Picture, new("time", "ms"),
        [
            new("render time", Looks.Hold, x, [.. pictures.Select(each => each.RenderMs)]),
            new("L_visu", Looks.Adaptive, x, [.. pictures.Select(each => (double?)each.VisuMs)]),
        ]) { FromZero = true, Marks = [.. LoadMarks(pictures)] };
        return new("Render time and L_visu from picture to picture", "Fig. 10",
            "While frames are ready in time, L_visu stays as it is whatever the render time does; beyond the limit it grows and scatters.", [plot]);
    }

    static IEnumerable<PlotMark> LoadMarks(MeasuredPicture[] pictures)
    {
        var loads = pictures.Select(each => each.Vertices).Distinct().Count();
        for (var i = 0; i < pictures.Length; i++)
        {
            if (pictures[i].Vertices is not int vertices || i > 0 && pictures[i - 1].Vertices == vertices) continue;
            // Names of more than six would run into one another.
            if (loads <= 6 || vertices % 500_000 == 0) yield return new(FormattableString.Invariant($"{vertices / 1e6:0.##} M"), i + 1);
        }
    }

    static CalibrationSection OverLoad(MeasuredPicture[] pictures)
    {
        var table = new FigureTable(Load, Render, new("render time deviation", "ms"), Visu, new("L_visu deviation", "ms"), new("pictures"));
        foreach (var load in pictures.Where(each => each.Vertices.HasValue).GroupBy(each => each.Vertices.Value).OrderBy(group => group.Key))
        {
            var (render, renderSd) = Middle.Of(load.Select(each => each.RenderMs.Value));
            var (visu, visuSd) = Middle.Of(load.Select(each => each.VisuMs));
            table.Add(load.Key / 1e6, render, renderSd, visu, visuSd, load.Count());
        }
        PlotTrace Middles(string label, string look, int column) => table.Trace(label, look, 0, column) with
        {
            Marked = true, Deviation = [.. table.Rows.Select(row => row[column + 1])],
        };
        var plot = new FigurePlot("Over the load", Load, new("time", "ms"), [Middles("render time", Looks.Hold, 1), Middles("L_visu", Looks.Adaptive, 3)])
        {
            FromZero = true,
        };
        return new("Render time and L_visu over the load", "Fig. 11a", "Median and middle 68 %. Both are constant up to a number of vertices that depends on the scene: "
            + "the render time, not the number, is what the headset watches.", [plot], table);
    }

    static CalibrationSection OverRenderTime(MeasuredPicture[] pictures, RangeFitResult fit)
    {
        var sorted = pictures.OrderBy(each => each.RenderMs).ToArray();
        var all = Points(sorted);
        PlotTrace[] traces = fit == null
            ? [all]
            : [all, new("L_visu of the profile", Looks.Quadratic, [sorted[0].RenderMs.Value, fit.ValidToRenderMs], [fit.VisuMs, fit.VisuMs])];
        PlotMark[] marks = fit?.LimitRenderMs is double limit ? [new(FormattableString.Invariant($"limit {limit:0.##} ms"), limit)] : [];
        return new("L_visu over the render time", "Fig. 11b", fit?.LimitRenderMs == null
            ? "No limit was reached: L_visu is known to be constant only up to the greatest render time seen."
            : "Left of the limit is the constant-latency range.",
            [new("Over render time", Render, Visu, traces) { FromZero = true, Marks = marks }]);
    }

    // The page joins traces by x and wants each once.
    static PlotTrace Points(MeasuredPicture[] sorted)
    {
        const double Step = 1e-4;
        var x = new double[sorted.Length];
        for (var i = 0; i < x.Length; i++) x[i] = Math.Max(Math.Round(sorted[i].RenderMs.Value, 4), i == 0 ? 0 : x[i - 1] + Step);
        return new("pictures", Looks.Adaptive, x, [.. sorted.Select(each => (double?)each.VisuMs)]) { Scattered = true };
    }
}
