using MathNet.Numerics.Statistics;

namespace Nowpose.Cli;

/// <summary>Quantiles as all results state them: linear between order statistics, the q-quantile of n values at rank q (n − 1).</summary>
static class Quantile
{
    /// <param name="values">In any order; at least one.</param>
    /// <param name="fraction">0 to 1.</param>
    public static double Of(IEnumerable<double> values, double fraction)
    {
        var sorted = values.ToArray();
        Array.Sort(sorted);
        return SortedArrayStatistics.QuantileCustom(sorted, fraction, QuantileDefinition.R7);
    }
}
