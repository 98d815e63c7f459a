using Nowpose.Cli.Calibrate;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Cli.Figures.Model;
using static Nowpose.Cli.Figures.Numbers;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Fig. 11: the constant-latency range, in plots of L_visu against the load and against the render time.</summary>
static class Figure11
{
    /// <summary>Maximum relative difference between two limits. Each deviates by −6 to +2 % from the true limit.</summary>
    const double LimitShare = 0.08;

    /// <summary>Maximum difference between the L_visu of a picture and the L_visu of the profile, ms.</summary>
    const double Sufficient = 3;

    /// <summary>Minimum number of pictures for computing a spread. Excludes the longest render times, which too few frames have.</summary>
    const int MinPictures = 30;

    const string Beyond = Figure11Texts.AboveLimit;

    public static Figure OverLoad(List<MeasuredPicture> sweep, RangeFitResult fit)
    {
        var (plot, table) = RangePlots.OverLoad(sweep);
        return new Figure("11a", Figure11Texts.OverLoad)
        {
            Claim = Figure11Texts.OverLoadClaim,
            Criteria = LoadCriteria(sweep, fit.VisuMs),
            Beyond = Beyond,
            Conditions = StudiedDisplay.Words,
            Table = table,
            Plots = [plot],
        };
    }

    /// <param name="other">The range of another scene, whose vertices take twice as long to render.</param>
    public static Figure OverRenderTime(List<MeasuredPicture> sweep, RangeFitResult fit, RangeFitResult other)
    {
        var table = new FigureTable(RangePlots.Load, RangePlots.Render, RangePlots.Visu);
        foreach (var picture in sweep.OrderBy(each => each.RenderMs)) table.Add(picture.Vertices.Value / 1e6, picture.RenderMs, picture.VisuMs);
        return new Figure("11b", Figure11Texts.OverRenderTime)
        {
            Claim = Figure11Texts.OverRenderTimeClaim,
            Criteria = RangeCriteria(sweep, fit.VisuMs, fit.LimitRenderMs, other.LimitRenderMs),
            Beyond = Figure11Texts.Beyond(Text(StudiedDisplay.TrueLimitMs), Beyond),
            Conditions = StudiedDisplay.Words,
            Table = table,
            Plots = [RangePlots.OverRenderTime(sweep, fit)],
        };
    }

    public static IReadOnlyList<Criterion> LoadCriteria(IEnumerable<MeasuredPicture> sweep, double storedMs)
    {
        var loads = sweep.GroupBy(each => each.Vertices.Value).OrderBy(load => load.Key).ToArray();
        var inside = loads.TakeWhile(IsInside).ToArray();
        var beyond = loads.Where(load => Quantile.Of(load.Select(each => each.RenderMs.Value), 0.5) > StudiedDisplay.TrueLimitMs);
        var worst = inside.Select(load => Math.Abs(Quantile.Of(load.Select(each => each.VisuMs), 0.5) - storedMs))
            .DefaultIfEmpty(double.PositiveInfinity).Max();
        return
        [
            new(Figure11Texts.MedianCriterion, worst < 1,
                inside.Length == 0 ? "no such load" : Figure11Texts.MedianMeasured(Text(worst), Text(inside[^1].Key / 1e6))),
            .. SpreadCriteria.Of(Figure11Texts.AtLoads, inside.SelectMany(load => load).Select(each => each.VisuMs),
                [.. beyond.Select(load => new SpreadGroup($"{Text(load.Key / 1e6)} million", load.Select(each => each.VisuMs)))]),
        ];
    }

    /// <param name="limitMs">The measured limit; null if there is none.</param>
    /// <param name="otherLimitMs">The measured limit in the other scene; null if there is none.</param>
    public static IReadOnlyList<Criterion> RangeCriteria(
        IReadOnlyCollection<MeasuredPicture> sweep, double storedMs, double? limitMs, double? otherLimitMs)
    {
        var inside = sweep.Where(each => !(each.RenderMs > limitMs)).Select(each => each.VisuMs).ToArray();
        var steps = sweep.Where(each => each.RenderMs > limitMs).GroupBy(each => (int)(each.RenderMs.Value - limitMs.Value))
            .Where(step => step.Count() >= MinPictures).OrderBy(step => step.Key);
        var stored = inside.Count(visuMs => Math.Abs(visuMs - storedMs) < Sufficient) / (double)inside.Length;
        return
        [
            new(Figure11Texts.SameLimit(Percent(LimitShare)),
                Math.Abs((otherLimitMs - limitMs) / limitMs ?? double.PositiveInfinity) <= LimitShare, $"{Limit(limitMs)} and {Limit(otherLimitMs)}"),
            new(Figure11Texts.Stored(Sufficient), stored >= 0.95, Percent(stored)),
            .. SpreadCriteria.Of(Figure11Texts.AtRenderTimes, inside,
                [.. steps.Select(step => new SpreadGroup(Figure11Texts.Step(Text(limitMs.Value + step.Key)), step.Select(each => each.VisuMs)))]),
        ];
    }

    // Of normally distributed values, 98 % are below the median plus two standard deviations.
    static bool IsInside(IEnumerable<MeasuredPicture> load)
    {
        var (median, deviation) = Middle.Of(load.Select(each => each.RenderMs.Value));
        return median + 2 * deviation < StudiedDisplay.TrueLimitMs;
    }

    static string Limit(double? ms) => ms is double limit ? $"{Text(limit)} ms" : "none";
}
