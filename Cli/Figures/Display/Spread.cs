using MathNet.Numerics.Statistics;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Spread of the middle 95 % of values. Single frames that were slow and single misread pictures do not change it.</summary>
/// <param name="Deviation">Standard deviation of the middle 95 %.</param>
/// <param name="Range">Largest minus smallest of the middle 95 %.</param>
readonly record struct Spread(double Deviation, double Range)
{
    const double Low = 0.025, High = 0.975;

    /// <param name="values">Any number; the spread of fewer than two is 0.</param>
    public static Spread Of(IEnumerable<double> values)
    {
        var all = values.ToArray();
        if (all.Length < 2) return default;
        double low = Quantile.Of(all, Low), high = Quantile.Of(all, High);
        return new(all.Where(value => value >= low && value <= high).StandardDeviation(), high - low);
    }
}
