using MathNet.Numerics.Statistics;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Finds L_visu and the constant-latency range: the maximum render time up to which L_visu is constant.</summary>
/// <remarks>
/// Schnierle &amp; Röck 2022, Fig. 11b. A pair is good if its L_visu is within the tolerance of the constant value (the plateau).
/// <see cref="RangeSplit"/> finds the render time at which the share of good pairs drops, by maximum likelihood. Misread pictures and
/// frames that waited behind a slow one therefore do not move the limit. If too few pairs lie beyond it, the result is the observed
/// range without a limit.
/// </remarks>
static class RangeFit
{
    /// <summary>Minimum number of pairs.</summary>
    public const int MinPairs = 20;

    /// <summary>Share of the pairs from which the initial plateau is estimated: those with the lowest render times.</summary>
    const double SeedShare = 0.2;

    /// <summary>Minimum tolerance around the plateau, ms. The camera and the 1 ms resolution of the codes cause a scatter of this size.</summary>
    const double MinToleranceMs = 3;

    /// <summary>Tolerance around the plateau, in standard deviations.</summary>
    const double Deviations = 3.5;

    /// <summary>Resolution of the codes, ms.</summary>
    const double ResolutionMs = 1;

    /// <summary>Maximum standard deviation of a plateau, ms. A 30 Hz display that is lit continuously has 9.6 ms.</summary>
    const double MaxSpreadMs = 10;

    /// <summary>Maximum relative gap without pictures above the limit. If the gap is larger, the limit is reported as uncertain.</summary>
    const double Coarse = 0.05;

    /// <summary>
    /// Position of the limit in the gap between the last good pictures and the first late ones, as a share of the gap. It is below the
    /// middle because a limit that is too high is worse than one that is too low. The second value limits the relative distance from the
    /// last good picture.
    /// </summary>
    const double IntoTheGap = 0.25, MaxShareAbove = 0.02;

    /// <summary>
    /// For a source with a resolution of one frame: quantile of the render times in range that must be low enough for the headset's monitor to
    /// return to the range.
    /// </summary>
    const double InRange = 0.95;

    /// <summary>Number of pairs just beyond the limit that are assumed to be misread.</summary>
    const int Misread = 2;

    const int MaxRounds = 8;

    /// <param name="pictures">At least <see cref="MinPairs"/> pictures with known render times, in any order.</param>
    /// <inheritdoc cref="Fit(IReadOnlyList{LatencyPair}, PairOrigin)"/>
    public static RangeFitResult Fit(IEnumerable<MeasuredPicture> pictures, PairOrigin origin = null) =>
        Fit([.. pictures.Select(each => new LatencyPair(each.RenderMs.Value, each.VisuMs))], origin);

    /// <param name="pairs">At least <see cref="MinPairs"/> pairs in any order.</param>
    /// <param name="origin">Source of the render times, which determines their resolution, and display rate; null if unknown.</param>
    /// <exception cref="InputException">There are too few pairs, or L_visu is not constant at the lowest render times.</exception>
    public static RangeFitResult Fit(IReadOnlyList<LatencyPair> pairs, PairOrigin origin = null)
    {
        if (pairs.Count < MinPairs)
            throw new InputException(RangeMessages.TooFewPairs(pairs.Count, MinPairs));
        var sorted = pairs.OrderBy(pair => pair.RenderMs).ThenBy(pair => pair.VisuMs).ToArray();
        var refreshMs = 1000 / origin?.Conditions.DisplayHz;
        var plateau = PlateauOf(sorted.Take(Math.Max(MinPairs / 2, (int)(SeedShare * sorted.Length))), refreshMs);
        var good = new bool[sorted.Length];
        var isLast = sorted.Select((pair, i) => i == sorted.Length - 1 || sorted[i + 1].RenderMs > pair.RenderMs).ToArray();
        var nearest = double.PositiveInfinity;
        // A frame that is one refresh late is not good, however much the pictures scatter.
        var halfRefresh = Math.Max(MinToleranceMs, refreshMs / 2 - ResolutionMs ?? double.PositiveInfinity);
        var split = default(RangeSplit);
        for (var round = 0; round < MaxRounds; round++)
        {
            var tolerance = Math.Min(Math.Max(MinToleranceMs, Deviations * plateau.Deviation), Math.Min(nearest, halfRefresh));
            for (var i = 0; i < sorted.Length; i++) good[i] = Math.Abs(sorted[i].VisuMs - plateau.Centre) <= tolerance;
            var before = split.Count;
            split = RangeSplit.Find(good, isLast);
            var inside = sorted.Take(split.Count).Where((_, i) => good[i]).ToArray();
            if (inside.Length < MinPairs / 2)
                throw new InputException(RangeMessages.NoPlateau);
            plateau = PlateauOf(inside, refreshMs);
            // A tolerance of half the distance between both medians keeps the pairs beyond the limit out of the plateau.
            if (split.IsReached) nearest = Math.Max(MinToleranceMs, Math.Abs(Median(Visu(sorted.Skip(split.Count))) - plateau.Centre) / 2);
            if (split.Count == before && round > 1) break;
        }
        return Result(sorted, good, split, origin?.Source);
    }

    static RangeFitResult Result(LatencyPair[] sorted, bool[] good, RangeSplit split, RenderTimeSourceKind? source)
    {
        var inside = sorted.Take(split.Count).Where((_, i) => good[i]).ToArray();
        var (mean, spread) = Visu(inside).MeanStandardDeviation();
        if (spread > MaxSpreadMs)
            throw new InputException(RangeMessages.Scatters(spread, MaxSpreadMs));
        (double Last, double Next) GapAt(int count)
        {
            var last = sorted[count - 1].RenderMs;
            return (last, split.IsReached ? sorted[Math.Min(count + Misread, sorted.Length - 1)].RenderMs : last);
        }
        var ((last, next), (lastPossible, open)) = (GapAt(split.Count), GapAt(split.MaxCount));
        var limit = Math.Min(last + IntoTheGap * (next - last), (1 + MaxShareAbove) * last);
        // The times of this source are groups one refresh apart, so the usual render time can be just below the limit.
        if (source == RenderTimeSourceKind.GpuCompletion)
            limit = Math.Max(limit, Quantile.Of(Render(inside), InRange) / MedianLimit.ClearlyInside);
        return new RangeFitResult(mean, spread, split.IsReached ? limit : null, split.IsReached ? limit : last, sorted.Length, inside.Length,
            split.Count - inside.Length, open > (1 + Coarse) * lastPossible && open > limit ? open : null);
    }

    static IEnumerable<double> Visu(IEnumerable<LatencyPair> pairs) => pairs.Select(pair => pair.VisuMs);

    static IEnumerable<double> Render(IEnumerable<LatencyPair> pairs) => pairs.Select(pair => pair.RenderMs);

    static double Median(IEnumerable<double> values) => Quantile.Of(values, 0.5);

    // Returns the constant L_visu within the range: centre and robust standard deviation, ms. If each frame is scanned twice, the median is in one of
    // the scans, and the mean of the pictures within a refresh interval is between them.
    static (double Centre, double Deviation) PlateauOf(IEnumerable<LatencyPair> pairs, double? refreshMs)
    {
        var visu = Visu(pairs).ToArray();
        var centre = Median(visu);
        if (refreshMs.HasValue) centre = visu.Where(each => Math.Abs(each - centre) <= refreshMs).Average();
        return (centre, Quantile.DeviationOf(visu.Select(each => each - centre)));
    }
}
