using MathNet.Numerics.Statistics;

namespace Nowpose.Studies;

/// <summary>Root mean square, 95th percentile and maximum of absolute errors.</summary>
public readonly record struct ErrorFigures(double Rms, double P95, double Maximum)
{
    /// <param name="errors">The errors; at least one.</param>
    public static ErrorFigures Of(IReadOnlyList<double> errors)
    {
        var sorted = errors.Select(Math.Abs).ToArray();
        Array.Sort(sorted);
        // All results use this definition of quantiles.
        var p95 = SortedArrayStatistics.QuantileCustom(sorted, 0.95, QuantileDefinition.R7);
        return new ErrorFigures(Math.Sqrt(sorted.Sum(error => error * error) / sorted.Length), p95, sorted[^1]);
    }
}
