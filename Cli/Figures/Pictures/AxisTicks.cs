namespace Nowpose.Cli.Figures.Pictures;

/// <summary>Computes round numbers along an axis: four to ten steps of 1, 2 or 5 times a power of ten.</summary>
static class AxisTicks
{
    public static IEnumerable<double> Of(double low, double high)
    {
        var step = Step(high - low);
        for (var i = (int)Math.Ceiling(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) yield return i * step;
    }

    /// <summary>Rounds a value down to a tick.</summary>
    public static double Floor(double value, double span) => Math.Floor(value / Step(span) + 1e-9) * Step(span);

    /// <summary>Rounds a value up to a tick.</summary>
    public static double Ceiling(double value, double span) => Math.Ceiling(value / Step(span) - 1e-9) * Step(span);

    static double Step(double span)
    {
        var power = Math.Pow(10, Math.Floor(Math.Log10(span / 4)));
        return power * (span / 4 / power) switch { >= 5 => 5, >= 2 => 2, _ => 1 };
    }
}
