using System.Globalization;
using System.Text;
using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>Writes a plot as a small SVG file. It has fixed light colours and no scripts, so that it looks the same in every viewer.</summary>
/// <param name="width">Width of the picture, px.</param>
sealed class SvgPlot(FigurePlot plot, int width)
{
    const int Height = 280;

    /// <summary>Number of points above which the points are drawn smaller.</summary>
    const int ManyPoints = 200;

    const int Left = 52, Right = 12, Top = 34, Bottom = 42;

    readonly SvgWriter _svg = new(width, Height, $"{plot.Title}: {string.Join(", ", plot.Traces.Select(t => t.Label))}");
    readonly double _x0 = plot.Traces.Min(t => t.X[0]);
    readonly double _x1 = plot.Traces.Max(t => t.X[^1]);
    readonly double _y0 = plot.YRange?.From ?? (plot.FromZero ? 0 : AxisTicks.Floor(plot.Traces.Min(t => t.Y.Min()!.Value), Span(plot)));
    readonly double _y1 = plot.YRange?.To ?? AxisTicks.Ceiling(plot.Traces.Max(t => t.Y.Max()!.Value), Span(plot));

    public string Draw()
    {
        Axes();
        // Clips the lines at the edge of the plot.
        _svg.Add($"<clipPath id=\"plot\"><rect x=\"{Left}\" y=\"{Top}\" width=\"{width - Left - Right}\" height=\"{Height - Top - Bottom + 3}\"/></clipPath>\n");
        foreach (var trace in plot.Traces) Draw(trace);
        foreach (var mark in plot.Marks) Mark(mark);
        Legend();
        return _svg.Finish();
    }

    static double Span(FigurePlot plot) =>
        plot.Traces.Max(t => t.Y.Max()!.Value) - (plot.FromZero ? 0 : plot.Traces.Min(t => t.Y.Min()!.Value));

    double X(double value) => Left + (value - _x0) / (_x1 - _x0) * (width - Left - Right);

    double Y(double value) => Height - Bottom - (value - _y0) / (_y1 - _y0) * (Height - Top - Bottom);

    void Axes()
    {
        foreach (var y in AxisTicks.Of(_y0, _y1))
        {
            _svg.Add($"<path d=\"M{Left} {Y(y):0.#}H{width - Right}\" stroke=\"#e3e7ec\"/>");
            _svg.Text(Left - 6, Y(y) + 4, "end", Number(y));
        }
        foreach (var x in AxisTicks.Of(_x0, _x1)) _svg.Text(X(x), Height - Bottom + 16, "middle", Number(x));
        _svg.Add($"<path d=\"M{Left} {Height - Bottom}H{width - Right}\" stroke=\"{SvgWriter.Muted}\"/>\n");
        _svg.Text((Left + width - Right) / 2.0, Height - 8, "middle", plot.X.Label);
        _svg.Add($"<text transform=\"translate(13 {(Top + Height - Bottom) / 2}) rotate(-90)\" text-anchor=\"middle\" fill=\"{SvgWriter.Muted}\" {SvgWriter.Font} font-size=\"12\">{plot.Y.Label}</text>\n");
    }

    void Draw(PlotTrace trace)
    {
        if (!trace.Scattered) Line(trace);
        if (trace.Deviation != null) Bars(trace);
        if (trace.Marked || trace.Scattered) Points(trace);
    }

    void Line(PlotTrace trace)
    {
        var path = new StringBuilder();
        for (var i = 0; i < trace.X.Count; i++)
        {
            if (trace.Y[i] is not double y) continue;
            var isJoined = i > 0 && trace.Y[i - 1] != null;
            if (trace.Stepped && isJoined) path.Append(CultureInfo.InvariantCulture, $"H{X(trace.X[i]):0.#}");
            path.Append(isJoined ? 'L' : 'M').Append(CultureInfo.InvariantCulture, $"{X(trace.X[i]):0.#} {Y(y):0.#}");
        }
        _svg.Add($"<path d=\"{path}\" fill=\"none\" clip-path=\"url(#plot)\" {PictureInk.Of(trace.Look).Stroke}/>\n");
    }

    void Bars(PlotTrace trace)
    {
        _svg.Add($"<path clip-path=\"url(#plot)\" fill=\"none\" stroke=\"{PictureInk.Of(trace.Look).Colour}\" d=\"");
        for (var i = 0; i < trace.X.Count; i++)
            if (trace.Y[i] is double y && trace.Deviation[i] is double half)
                _svg.Add($"M{X(trace.X[i]):0.#} {Y(y + half):0.#}V{Y(y - half):0.#}");
        _svg.Add($"\"/>\n");
    }

    // Draws all points as dots of one path, because a thousand circles would make the file large.
    void Points(PlotTrace trace)
    {
        _svg.Add($"<path clip-path=\"url(#plot)\" stroke=\"{PictureInk.Of(trace.Look).Colour}\" stroke-width=\"{(trace.Scattered && trace.X.Count > ManyPoints ? 3 : 5)}\" stroke-linecap=\"round\" d=\"");
        for (var i = 0; i < trace.X.Count; i++)
            if (trace.Y[i] is double y) _svg.Add($"M{X(trace.X[i]):0.#} {Y(y):0.#}h0");
        _svg.Add($"\"/>\n");
    }

    void Mark(PlotMark mark)
    {
        _svg.Add($"<path d=\"M{X(mark.X):0.#} {Top}V{Height - Bottom}\" stroke=\"{SvgWriter.Muted}\" stroke-dasharray=\"2 3\"/>");
        _svg.Text(X(mark.X) + 4, Height - Bottom - 6, "start", mark.Label);
    }

    void Legend()
    {
        double x = Left;
        foreach (var trace in plot.Traces)
        {
            if (trace.Scattered) _svg.Add($"<circle cx=\"{x + 16:0.#}\" cy=\"17\" r=\"3\" fill=\"{PictureInk.Of(trace.Look).Colour}\"/>");
            else _svg.Add($"<path d=\"M{x:0.#} 17h24\" {PictureInk.Of(trace.Look).Stroke}/>");
            _svg.Text(x + 29, 21, "start", trace.Label, SvgWriter.Ink);
            x += 29 + 7.1 * trace.Label.Length + 12;
        }
    }

    static string Number(double value) => value.ToString("0.###", CultureInfo.InvariantCulture).Replace('-', '−');
}
