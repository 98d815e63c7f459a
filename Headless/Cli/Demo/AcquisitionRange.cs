using System.CommandLine.Parsing;
using System.Globalization;

namespace Nowpose.Cli.Demo;

/// <summary>What subscription and middleware add to each sample before it is sent, ms, evenly between two bounds.</summary>
readonly record struct AcquisitionRange(double LeastMs, double GreatestMs)
{
    const double Longest = 2000;

    public static AcquisitionRange Parse(ArgumentResult result)
    {
        var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        var parts = text.Split('-');
        if (parts.Length == 2 && TryNumber(parts[0], out var least) && TryNumber(parts[1], out var greatest) && least <= greatest && greatest <= Longest)
            return new AcquisitionRange(least, greatest);
        result.AddError($"--acquisition-ms: '{text}' is not a range; allowed is MIN-MAX with 0 <= MIN <= MAX <= {Longest} ms, such as 55-105.");
        return default;
    }

    static bool TryNumber(string text, out double value) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out value);

    public override string ToString() => FormattableString.Invariant($"{LeastMs}-{GreatestMs}");
}
