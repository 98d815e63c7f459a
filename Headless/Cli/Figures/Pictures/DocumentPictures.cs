using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>The pictures of the documentation, drawn from the figures' data.</summary>
static class DocumentPictures
{
    static readonly (string File, string Figure, string[] Traces)[] Pictures =
    [
        ("error-over-sampling-interval.svg", "13a", ["quadratic", "adaptive"]),
        ("error-over-stamp-error.svg", "13d", ["quadratic", "adaptive"]),
        ("swing.svg", "16", ["ground truth", "uncompensated", "quadratic", "adaptive"]),
        ("clock-error.svg", "8", ["ransac", "default"]),
    ];

    /// <returns>The files written: those whose figure was computed.</returns>
    public static IReadOnlyList<string> Write(string folder, IReadOnlyList<Figure> figures)
    {
        var paths = new List<string>();
        foreach (var (file, number, traces) in Pictures)
        {
            if (figures.FirstOrDefault(f => f.Number == number) is not Figure figure) continue;
            var plot = figure.Plots[0] with { Traces = [.. figure.Plots[0].Traces.Where(t => traces.Contains(t.Label))] };
            paths.Add(Path.Combine(folder, file));
            File.WriteAllText(paths[^1], new SvgPlot(plot).Draw());
        }
        return paths;
    }
}
