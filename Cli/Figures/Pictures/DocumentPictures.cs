using Nowpose.Cli.Figures.Model;
using Nowpose.Gateway;

namespace Nowpose.Cli.Figures.Pictures;

/// <summary>Draws the pictures of the documentation from the figures' data.</summary>
static class DocumentPictures
{
    const int Narrow = 420, Wide = 620;

    static readonly (string File, string Figure, int Plot, int Width, string[] Traces)[] Pictures =
    [
        ("error-over-sampling-interval.svg", "13a", 0, Narrow, ["quadratic", "adaptive"]),
        ("error-over-stamp-error.svg", "13d", 0, Narrow, ["quadratic", "adaptive"]),
        ("swing.svg", "16", 0, Wide, ["ground truth", "uncompensated", "quadratic", "adaptive"]),
        ("clock-error.svg", "8", 0, Wide, ["ransac", "default"]),
        ("visu-at-normal-load.svg", "10", 0, Narrow, ["render time", "L_visu"]),
        ("visu-at-high-load.svg", "10", 1, Narrow, ["render time", "L_visu"]),
        ("visu-over-load.svg", "11a", 0, Narrow, ["render time", "L_visu"]),
        ("visu-over-render-time.svg", "11b", 0, Narrow, ["pictures", "L_visu of the profile"]),
    ];

    /// <returns>The files that were written. Pictures of figures that were not computed are skipped.</returns>
    public static IReadOnlyList<string> Write(string folder, IReadOnlyList<Figure> figures)
    {
        var paths = new List<string>();
        foreach (var (file, number, index, width, traces) in Pictures)
        {
            if (figures.FirstOrDefault(f => f.Number == number) is not Figure figure) continue;
            var plot = figure.Plots[index] with { Traces = [.. figure.Plots[index].Traces.Where(t => traces.Contains(t.Label))] };
            paths.Add(Path.Combine(folder, file));
            OutputFile.Write(paths[^1], new SvgPlot(plot, width).Draw());
        }
        return paths;
    }
}
