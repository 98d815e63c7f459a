using MathNet.Numerics.Statistics;

namespace Nowpose.Cli;

/// <summary>Computes quantiles by linear interpolation between order statistics: the q-quantile of n values has rank q (n − 1).</summary>
static class Quantile
{
    /// <summary>Standard deviation of a normal distribution divided by its median absolute deviation.</summary>
    const double PerMedianDeviation = 1.4826;

    /// <param name="values">One value or more, in any order.</param>
    /// <param name="fraction">0 to 1.</param>
    public static double Of(IEnumerable<double> values, double fraction)
    {
        var sorted = values.ToArray();
        Array.Sort(sorted);
        return SortedArrayStatistics.QuantileCustom(sorted, fraction, QuantileDefinition.R7);
    }

    /// <summary>Returns the quantile; null for an empty list.</summary>
    public static double? OfOrNull(IEnumerable<double> values, double fraction)
    {
        var list = values.ToList();
        return list.Count == 0 ? null : Of(list, fraction);
    }

    /// <summary>
    /// Returns the standard deviation of normally distributed residuals, from their median absolute value. A few outliers hardly change it.
    /// </summary>
    public static double DeviationOf(IEnumerable<double> residuals) => PerMedianDeviation * Of(residuals.Select(Math.Abs), 0.5);
}
