using MathNet.Numerics.Statistics;
using Nowpose.Cli.Calibrate.Range;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>The constant L_visu of measurements without render times.</summary>
/// <param name="VisuMs">Mean of the used pictures.</param>
/// <param name="SpreadMs">Standard deviation between individual pictures.</param>
/// <param name="Count">Number of used pictures.</param>
sealed record Plateau(double VisuMs, double SpreadMs, int Count)
{
    /// <summary>Minimum number of pictures for a profile.</summary>
    const int MinCount = 2;

    /// <summary>Maximum standard deviation. A larger one means that the pictures were taken at different loads.</summary>
    const double MaxSpreadMs = 10;

    const double MinToleranceMs = 3, Deviations = 3.5;

    /// <summary>Averages pictures at one load, without those far from their median.</summary>
    /// <returns>Null for fewer than two pictures, or if L_visu scatters too much to be constant.</returns>
    public static Plateau OfOneLoad(IReadOnlyList<double> visuMs) =>
        visuMs.Count >= MinCount && NearMedian(visuMs) is { SpreadMs: <= MaxSpreadMs } plateau ? plateau : null;

    /// <summary>Averages the pictures near their median, which excludes frames that waited behind a slow one.</summary>
    /// <param name="visuMs">One picture or more.</param>
    public static Plateau NearMedian(IReadOnlyList<double> visuMs)
    {
        var median = Quantile.Of(visuMs, 0.5);
        var tolerance = Math.Max(MinToleranceMs, Deviations * Quantile.DeviationOf(visuMs.Select(each => each - median)));
        double[] near = [.. visuMs.Where(each => Math.Abs(each - median) <= tolerance)];
        return new(near.Average(), near.Length > 1 ? near.StandardDeviation() : 0, near.Length);
    }

    /// <summary>
    /// Averages pictures at several loads, up to the maximum load with constant L_visu. That load is found in the same way as the maximum
    /// render time. Frames that are late at higher loads would increase the mean.
    /// </summary>
    /// <returns>Null if L_visu cannot be determined.</returns>
    public static Plateau OfSweep(IEnumerable<MeasuredPicture> pictures)
    {
        // RangeFit expects render times, but any number that increases with the load is sufficient.
        LatencyPair[] pairs = [.. pictures.Where(each => each.Vertices.HasValue).Select(each => new LatencyPair(1 + each.Vertices.Value / 1e6, each.VisuMs))];
        if (pairs.Length < RangeFit.MinPairs) return null;
        try
        {
            var fit = RangeFit.Fit(pairs);
            return new(fit.VisuMs, fit.SpreadMs, fit.Used);
        }
        catch (InputException)
        {
            // L_visu is not constant at any load.
            return null;
        }
    }
}
