using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;

namespace Nowpose.Gateway.Options;

/// <summary>Creates options that take a range of milliseconds, MIN-MAX, or a single number as both ends.</summary>
public static class RangeOption
{
    public static Option<MillisecondRange> Create(string name, string description, MillisecondRange standard, double limit)
    {
        return new Option<MillisecondRange>(name)
        {
            Description = FormattableString.Invariant($"{description} [MIN-MAX or one number, 0 to {limit} ms]"),
            HelpName = "MIN-MAX",
            DefaultValueFactory = _ => standard,
            CustomParser = result => Parse(result, name, limit),
        };
    }

    static MillisecondRange Parse(ArgumentResult result, string name, double limit)
    {
        var text = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        var ends = text.Split('-');
        if (ends.Length <= 2 && IsNumber(ends[0], out var min) && IsNumber(ends[^1], out var max) && min <= max && max <= limit)
            return new MillisecondRange(min, max);
        result.AddError(OptionMessages.NotARange(name, text, limit));
        return default;
    }

    // Does not accept a sign, because the hyphen separates the two ends.
    static bool IsNumber(string text, out double value) =>
        double.TryParse(text, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out value);
}
