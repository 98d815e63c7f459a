using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Fig. 10: render time and L_visu at a normal and at a high load.</summary>
static class Figure10
{
    /// <summary>Maximum standard deviation, as measured with a camera, at which L_visu counts as constant, ms.</summary>
    const double Constant = 2;

    public static Figure Of(List<MeasuredPicture> normal, List<MeasuredPicture> high)
    {
        var table = new FigureTable(RangePlots.Picture, new("render time at 300000", "ms"), new("L_visu at 300000", "ms"),
            new("render time at 1500000", "ms"), new("L_visu at 1500000", "ms"));
        // One row per picture. The loads of a sweep have nearly the same number of pictures.
        for (var i = 0; i < Math.Max(normal.Count, high.Count); i++) table.Add([i + 1, .. ValuesOf(normal, i), .. ValuesOf(high, i)]);
        return new Figure("10", Figure10Texts.Title)
        {
            Claim = Figure10Texts.Claim,
            Criteria = Criteria(normal, high),
            Conditions = StudiedDisplay.Words,
            Table = table,
            Plots = [RangePlots.OverPictures("300 000 vertices", normal), RangePlots.OverPictures("1 500 000 vertices", high)],
        };
    }

    static double?[] ValuesOf(List<MeasuredPicture> pictures, int i) => i < pictures.Count ? [pictures[i].RenderMs, pictures[i].VisuMs] : [null, null];

    public static IReadOnlyList<Criterion> Criteria(IReadOnlyList<MeasuredPicture> normal, IReadOnlyList<MeasuredPicture> high)
    {
        double[] latencies = [.. normal.Select(each => each.VisuMs)];
        var spread = Spread.Of(latencies);
        return
        [
            new(Figure10Texts.Criterion(Constant), spread.Deviation < Constant,
                $"{Text(Quantile.Of(latencies, 0.5))} ± {Text(spread.Deviation)} ms"),
            .. SpreadCriteria.Of("At 1 500 000 vertices,", latencies, [new("1.5 million", high.Select(each => each.VisuMs))]),
        ];
    }
}
