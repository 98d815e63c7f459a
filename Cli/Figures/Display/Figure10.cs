using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Fig. 10: render time and L_visu at a normal and at a high load.</summary>
static class Figure10
{
    /// <summary>Maximum scatter of a constant L_visu as read by a camera, ms.</summary>
    const double Constant = 2;

    public static Figure Of(List<MeasuredPicture> normal, List<MeasuredPicture> high)
    {
        var table = new FigureTable(RangePlots.Picture, new("render time at 300000", "ms"), new("L_visu at 300000", "ms"),
            new("render time at 1500000", "ms"), new("L_visu at 1500000", "ms"));
        for (var i = 0; i < normal.Count; i++) table.Add(i + 1, normal[i].RenderMs, normal[i].VisuMs, high[i].RenderMs, high[i].VisuMs);
        return new Figure("10", "Render time and L_visu at two loads")
        {
            Claim = "At a normal load, 300 000 vertices, L_visu does not depend on the render time; at a high one, 1 500 000, it does.",
            Criteria = Criteria(normal, high),
            Conditions = DisplayConditions.Words,
            Table = table,
            Plots = [RangePlots.OverPictures("300 000 vertices", normal), RangePlots.OverPictures("1 500 000 vertices", high)],
        };
    }

    public static IReadOnlyList<Criterion> Criteria(List<MeasuredPicture> normal, List<MeasuredPicture> high)
    {
        var (middle, scatter) = Middle.Of(normal.Select(each => each.VisuMs));
        var (highMiddle, _) = Middle.Of(high.Select(each => each.VisuMs));
        var (rangeMs, range) = (high.Max(each => each.VisuMs) - high.Min(each => each.VisuMs), normal.Max(each => each.VisuMs) - middle);
        return
        [
            new($"At 300 000 the middle 68 % of L_visu lie within {Constant} ms.", scatter < Constant, $"{Text(middle)} ± {Text(scatter)} ms, at most {Text(range)} ms more"),
            new("At 1 500 000 L_visu is longer by a refresh or more, 16.7 ms.", highMiddle - middle >= 16, $"{Text(highMiddle - middle)} ms longer"),
            new("At 1 500 000 it varies by a refresh or more.", rangeMs >= 16, $"by {Text(rangeMs)} ms"),
        ];
    }
}
