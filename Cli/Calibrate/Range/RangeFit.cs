using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>Finds the constant-latency range from pictures at several loads: L_visu, and the maximum render time with constant L_visu.</summary>
/// <remarks>
/// Schnierle &amp; Röck 2022, Fig. 11b. A pair is good when its L_visu is that of the plateau. The limit is where the share of good
/// pairs changes, by maximum likelihood (<see cref="RangeSplit"/>), so that neither misread pictures nor frames that waited
/// behind a slow one move it. Without enough pairs beyond it, the result is the observed range instead of a limit.
/// </remarks>
static class RangeFit
{
    /// <summary>Minimum number of pairs.</summary>
    public const int MinPairs = 20;

    /// <summary>Share of the pairs, those with the lowest render times, from which the initial plateau is estimated.</summary>
    const double SeedShare = 0.2;

    /// <summary>Minimum tolerance around the plateau, ms: scatter that a camera and codes of 1 ms add to a constant latency.</summary>
    const double MinToleranceMs = 3;

    /// <summary>Tolerance around the plateau in standard deviations.</summary>
    const double Deviations = 3.5;

    /// <summary>Maximum standard deviation of a plateau, ms. A 30 Hz display that is lit continuously causes 9.6 ms.</summary>
    const double MaxSpreadMs = 10;

    /// <summary>Relative distance from the limit to the next pictures above which the limit is reported as uncertain.</summary>
    const double Coarse = 0.05;

    /// <summary>
    /// Position of the limit in the gap between the last pictures on time and the first late ones, as a share of the gap. A limit
    /// that is too high is three times as bad as one that is too low. The second value limits the relative excess over the last picture.
    /// </summary>
    const double IntoTheGap = 0.25, MaxShareAbove = 0.02;

    /// <summary>Number of pairs beyond the limit that may be misread.</summary>
    const int Misread = 2;

    const int MaxRounds = 8;

    /// <param name="pairs">At least <see cref="MinPairs"/> pairs, in any order.</param>
    /// <exception cref="InputException">There are too few pairs, or L_visu is not constant at the lowest render times.</exception>
    public static RangeFitResult Fit(IReadOnlyList<LatencyPair> pairs)
    {
        if (pairs.Count < MinPairs)
            throw new InputException(RangeMessages.TooFewPairs(pairs.Count, MinPairs));
        var sorted = pairs.OrderBy(pair => pair.RenderMs).ThenBy(pair => pair.VisuMs).ToArray();
        var plateau = Plateau.Of(sorted.Take(Math.Max(MinPairs / 2, (int)(SeedShare * sorted.Length))));
        var good = new bool[sorted.Length];
        var isLast = sorted.Select((pair, i) => i == sorted.Length - 1 || sorted[i + 1].RenderMs > pair.RenderMs).ToArray();
        var nearest = double.PositiveInfinity;
        var split = default(RangeSplit);
        for (var round = 0; round < MaxRounds; round++)
        {
            var tolerance = Math.Min(Math.Max(MinToleranceMs, Deviations * plateau.Deviation), nearest);
            for (var i = 0; i < sorted.Length; i++) good[i] = Math.Abs(sorted[i].VisuMs - plateau.Centre) <= tolerance;
            var before = split.Count;
            split = RangeSplit.Find(good, isLast);
            var inside = sorted.Take(split.Count).Where((_, i) => good[i]).ToArray();
            if (inside.Length < MinPairs / 2)
                throw new InputException(RangeMessages.NoPlateau);
            plateau = Plateau.Of(inside);
            // Pairs beyond the limit are closer to the median beyond it than to the plateau, so half that distance limits the tolerance.
            if (split.IsReached) nearest = Math.Max(MinToleranceMs, Math.Abs(Median(Visu(sorted.Skip(split.Count))) - plateau.Centre) / 2);
            if (split.Count == before && round > 1) break;
        }
        return Result(sorted, good, split);
    }

    static RangeFitResult Result(LatencyPair[] sorted, bool[] good, RangeSplit split)
    {
        var inside = Visu(sorted.Take(split.Count).Where((_, i) => good[i])).ToArray();
        var mean = inside.Average();
        var spread = Math.Sqrt(inside.Sum(visu => (visu - mean) * (visu - mean)) / Math.Max(1, inside.Length - 1));
        if (spread > MaxSpreadMs)
            throw new InputException(RangeMessages.Scatters(spread, MaxSpreadMs));
        (double Last, double Next) GapAt(int count)
        {
            var last = sorted[count - 1].RenderMs;
            return (last, split.IsReached ? sorted[Math.Min(count + Misread, sorted.Length - 1)].RenderMs : last);
        }
        var ((last, next), (lastPossible, open)) = (GapAt(split.Count), GapAt(split.MaxCount));
        var limit = Math.Min(last + IntoTheGap * (next - last), (1 + MaxShareAbove) * last);
        return new RangeFitResult(mean, spread, limit, split.IsReached, sorted.Length, inside.Length, split.Count - inside.Length,
            open > (1 + Coarse) * lastPossible ? open : (double?)null);
    }

    static IEnumerable<double> Visu(IEnumerable<LatencyPair> pairs) => pairs.Select(pair => pair.VisuMs);

    static double Median(IEnumerable<double> values) => Quantile.Of(values, 0.5);

    /// <summary>Median and robust standard deviation of L_visu, ms.</summary>
    readonly struct Plateau
    {
        /// <summary>Standard deviation of a normal distribution divided by its median absolute deviation.</summary>
        const double PerMedianDeviation = 1.4826;

        Plateau(double centre, double deviation)
        {
            Centre = centre;
            Deviation = deviation;
        }

        public double Centre { get; }
        public double Deviation { get; }

        public static Plateau Of(IEnumerable<LatencyPair> pairs)
        {
            var visu = Visu(pairs).ToArray();
            var centre = Median(visu);
            return new Plateau(centre, PerMedianDeviation * Median(visu.Select(each => Math.Abs(each - centre))));
        }
    }
}
