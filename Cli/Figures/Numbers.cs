using System.Globalization;

namespace Nowpose.Cli.Figures;

/// <summary>Formats numbers for sentences, with few digits and a decimal point.</summary>
static class Numbers
{
    /// <summary>Formats a value without decimals from 100 on, with at most one from 10 on, two from 0.1 on, and four below 0.1.</summary>
    public static string Text(double value)
    {
        var size = Math.Abs(value);
        var format = size >= 99.5 ? "0" : size >= 9.95 ? "0.#" : size >= 0.1 || size == 0 ? "0.##" : "0.####";
        return value.ToString(format, CultureInfo.InvariantCulture);
    }

    public static string Mm(double value) => Text(value) + " mm";

    public static string Percent(double share) => (100 * share).ToString("0.#", CultureInfo.InvariantCulture) + " %";
}
