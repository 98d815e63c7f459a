using MathNet.Numerics.Statistics;

namespace Nowpose.Cli;

/// <summary>Quantiles for all results: linear between order statistics. The q-quantile of n values is at rank q (n − 1).</summary>
static class Quantile
{
    /// <param name="values">At least one value, in any order.</param>
    /// <param name="fraction">0 to 1.</param>
    public static double Of(IEnumerable<double> values, double fraction)
    {
        var sorted = values.ToArray();
        Array.Sort(sorted);
        return SortedArrayStatistics.QuantileCustom(sorted, fraction, QuantileDefinition.R7);
    }
}
