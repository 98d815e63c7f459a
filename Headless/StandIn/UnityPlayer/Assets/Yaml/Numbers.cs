using System.Globalization;

namespace Nowpose.UnityPlayer.Assets.Yaml;

/// <summary>Reads and writes numbers in the format of Unity's files, independent of the culture of the machine.</summary>
static class Numbers
{
    public static string Write(long value) => value.ToString(CultureInfo.InvariantCulture);

    /// <summary>Returns the shortest string that is read back as the same value. Exponents have the form <c>1e-7</c>.</summary>
    public static string Write(float value) => Exponent(value.ToString("R", CultureInfo.InvariantCulture));

    /// <inheritdoc cref="Write(float)"/>
    public static string Write(double value) => Exponent(value.ToString("R", CultureInfo.InvariantCulture));

    public static bool TryRead(string text, out long value) =>
        long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out value);

    public static bool TryRead(string text, out double value) =>
        double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && double.IsFinite(value);

    public static bool TryRead(string text, out float value) =>
        float.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out value) && float.IsFinite(value);

    static string Exponent(string text)
    {
        var e = text.IndexOf('E');
        return e < 0 ? text : text[..e] + "e" + Write(long.Parse(text[(e + 1)..], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture));
    }
}
