using Nowpose.Latency;
using Nowpose.Latency.Calibration;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>L_visu where no range over the render time can be told.</summary>
/// <param name="VisuMs">Mean of the pictures that count.</param>
/// <param name="SpreadMs">Standard deviation of a single one.</param>
/// <param name="Count">How many count.</param>
sealed record Plateau(double VisuMs, double SpreadMs, int Count)
{
    /// <summary>Of which a profile is made.</summary>
    const int LeastCount = 2;

    /// <summary>What scatters more, standard deviation, is not one load's.</summary>
    const double GreatestSpreadMs = 10;

    const double LeastToleranceMs = 3, Deviations = 3.5, PerMedianDeviation = 1.4826;

    /// <summary>Of pictures at one load: those near their median, so that frames behind a slow one do not count.</summary>
    /// <returns>Null for fewer than two, and where L_visu scatters too much to be constant.</returns>
    public static Plateau OfOneLoad(IReadOnlyList<double> visuMs)
    {
        if (visuMs.Count < LeastCount) return null;
        var median = Quantile.Of(visuMs, 0.5);
        var tolerance = Math.Max(LeastToleranceMs, Deviations * PerMedianDeviation * Quantile.Of(visuMs.Select(each => Math.Abs(each - median)), 0.5));
        double[] near = [.. visuMs.Where(each => Math.Abs(each - median) <= tolerance)];
        var mean = near.Average();
        var spread = Math.Sqrt(near.Sum(each => (each - mean) * (each - mean)) / Math.Max(1, near.Length - 1));
        return spread <= GreatestSpreadMs ? new(mean, spread, near.Length) : null;
    }

    /// <summary>
    /// Of pictures at several loads: up to which load L_visu is constant is found as it is over the render time. Without it the
    /// frames that were late under load would be taken for L_visu.
    /// </summary>
    /// <returns>Null where it cannot be told.</returns>
    public static Plateau OfSweep(IEnumerable<MeasuredPicture> pictures)
    {
        // Any number that grows with the load will do.
        LatencyPair[] pairs = [.. pictures.Where(each => each.Vertices.HasValue).Select(each => new LatencyPair(1 + each.Vertices.Value / 1e6, each.VisuMs))];
        if (pairs.Length < RangeFit.LeastPairs) return null;
        try
        {
            var fit = RangeFit.Fit(pairs);
            return new(fit.VisuMs, fit.SpreadMs, fit.Used);
        }
        catch (InputException)
        {
            // Constant at no load.
            return null;
        }
    }
}
