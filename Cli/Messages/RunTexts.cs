using System.Globalization;

namespace Nowpose.Cli.Messages;

/// <summary>Texts in the tables of both <c>demo</c> and <c>headset</c>.</summary>
static class RunTexts
{
    /// <summary>Returns a dash for an unknown value.</summary>
    public static string Number(double? value, string format, string unit = "") =>
        value is double number ? number.ToString(format, CultureInfo.InvariantCulture) + unit : "–";

    public static string Counts(int frames, long samples, long dropped) => FormattableString.Invariant($"{frames}, {samples}, {dropped}");
}
