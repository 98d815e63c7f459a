using MathNet.Numerics.Statistics;

namespace Nowpose.Cli.Figures.Display;

/// <summary>Spread of the middle 95 % of values. Individual slow frames and misread pictures do not change it.</summary>
/// <param name="Deviation">Standard deviation of the middle 95 %.</param>
/// <param name="Range">Maximum minus minimum of the middle 95 %.</param>
readonly record struct Spread(double Deviation, double Range)
{
    const double Low = 0.025, High = 0.975;

    /// <summary>Minimum number of values. With fewer, none would be in the middle.</summary>
    const int MinValues = 3;

    /// <param name="values">Any number of values. The spread of fewer than three is 0.</param>
    public static Spread Of(IEnumerable<double> values)
    {
        var all = values.ToArray();
        return all.Length < MinValues ? default : new(MiddleOf(all).StandardDeviation(), Quantile.Of(all, High) - Quantile.Of(all, Low));
    }

    /// <summary>Gets the spread of all groups together. Each group is taken relative to its own mean, so the means can differ.</summary>
    public static Spread Within(IEnumerable<SpreadGroup> groups) => Of(groups.SelectMany(group =>
    {
        var all = group.VisuMs.ToArray();
        var mean = MiddleOf(all).Mean();
        return all.Select(ms => ms - mean);
    }));

    static double[] MiddleOf(double[] values)
    {
        if (values.Length < MinValues) return values;
        double low = Quantile.Of(values, Low), high = Quantile.Of(values, High);
        return [.. values.Where(value => value >= low && value <= high)];
    }
}

/// <summary>A group of pictures beyond the range with its own mean, for example the pictures at one load.</summary>
/// <param name="Name">Name of the group, for example "1.4 million".</param>
/// <param name="VisuMs">L_visu of the pictures, ms.</param>
sealed record SpreadGroup(string Name, IEnumerable<double> VisuMs);
