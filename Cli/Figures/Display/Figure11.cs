using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures.Model;
using Nowpose.Latency;
using Nowpose.Latency.Calibration;
using Nowpose.Latency.Conditions;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Fig. 11: the constant-latency range, over the load and over the render time.</summary>
static class Figure11
{
    /// <summary>Render time limit of the simulated display: a refresh interval minus the latch, ms.</summary>
    const double TrueLimitMs = 1000 / 60.0 - 1.5;

    const double BelowShare = 0.06, AboveShare = 0.02;

    public static Figure OverLoad(List<MeasuredPicture> sweep, RangeFitResult fit)
    {
        var (plot, table) = RangePlots.OverLoad(sweep);
        return new Figure("11a", "Render time and L_visu over the load")
        {
            Claim = "Up to a number of vertices L_visu may be taken as constant; beyond, it grows and scatters.",
            Criteria = LoadCriteria(table, fit),
            Conditions = DisplayConditions.Words,
            Table = table,
            Plots = [plot],
        };
    }

    public static Figure OverRenderTime(List<MeasuredPicture> sweep, RangeFitResult fit)
    {
        var table = new FigureTable(RangePlots.Load, RangePlots.Render, RangePlots.Visu);
        foreach (var picture in sweep.OrderBy(each => each.RenderMs)) table.Add(picture.Vertices.Value / 1e6, picture.RenderMs, picture.VisuMs);
        return new Figure("11b", "L_visu over the render time")
        {
            Claim = "Over the render time, which the program can measure, the constant-latency range does not depend on what is drawn: "
                + "within it one stored L_visu serves, beyond it L_visu varies too much to be compensated.",
            Criteria = RangeCriteria(sweep, fit),
            Beyond = "The end of the range is found by the likeliest split of good and bad pictures, and watched by the median of 15 frames.",
            Conditions = DisplayConditions.Words,
            Table = table,
            Plots = [RangePlots.OverRenderTime(sweep, fit)],
        };
    }

    static Criterion[] LoadCriteria(FigureTable table, RangeFitResult fit)
    {
        var inside = table.Rows.Where(row => row[1] + 2 * row[2] < TrueLimitMs).ToArray();
        var outside = table.Rows.Where(row => row[1] > TrueLimitMs + 1.5).ToArray();
        var worst = inside.Max(row => Math.Abs(row[3].Value - fit.VisuMs));
        return
        [
            new("At loads whose render time stays below the limit, the median of L_visu is the same within 1 ms.", worst < 1,
                $"within {Text(worst)} ms up to {Text(inside.Max(row => row[0].Value))} million"),
            new("At loads beyond it, the middle 68 % are at least twice as wide or 16 ms later.",
                outside.All(row => row[4] > 2 * inside.Max(each => each[4].Value) || row[3] > fit.VisuMs + 16), $"from {Text(outside[0][0].Value)} million on"),
        ];
    }

    static Criterion[] RangeCriteria(List<MeasuredPicture> sweep, RangeFitResult fit)
    {
        var limit = fit.LimitRenderMs ?? 0;
        var good = sweep.Where(each => each.RenderMs <= limit).Select(each => Math.Abs(each.VisuMs - fit.VisuMs) < 3).ToArray();
        var bad = sweep.Where(each => each.RenderMs > limit).Select(each => Math.Abs(each.VisuMs - fit.VisuMs) >= 3).ToArray();
        return
        [
            new($"The limit that is found is the display's own, {Text(TrueLimitMs)} ms, within −6 and +2 %.",
                limit >= (1 - BelowShare) * TrueLimitMs && limit <= (1 + AboveShare) * TrueLimitMs, $"{Text(limit)} ms"),
            new("Below it 95 % of the pictures have the stored L_visu within 3 ms.", good.Count(each => each) >= 0.95 * good.Length, Percent(good.Count(each => each) / (double)good.Length)),
            new("Beyond it 95 % have not.", bad.Count(each => each) >= 0.95 * bad.Length, Percent(bad.Count(each => each) / (double)bad.Length)),
        ];
    }
}
