namespace Nowpose.Cli.Calibrate.Range;

/// <summary>
/// Computes the median and half the width of the middle 68 %. For a normal distribution these are mean and standard deviation. A few
/// misread pictures do not change them.
/// </summary>
static class Middle
{
    const double Below = 0.16, Above = 0.84;

    /// <param name="values">At least one value.</param>
    public static (double Median, double Deviation) Of(IEnumerable<double> values)
    {
        var all = values.ToArray();
        return (Quantile.Of(all, 0.5), (Quantile.Of(all, Above) - Quantile.Of(all, Below)) / 2);
    }
}
