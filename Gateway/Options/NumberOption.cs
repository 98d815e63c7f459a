using System.CommandLine;
using System.CommandLine.Parsing;
using System.Globalization;
using System.Numerics;

namespace Nowpose.Gateway.Options;

/// <summary>Creates options that take a number within a range. An invalid value gives one line with option, value, unit and range.</summary>
public static class NumberOption
{
    /// <param name="unit">Unit written after numbers in messages, such as "ms" or "s"; empty if the numbers have no unit.</param>
    public static Option<T> Create<T>(string name, string description, T standard, T min, T max, string unit)
        where T : INumber<T>
    {
        return new Option<T>(name)
        {
            Description = Invariant($"{description} [{min} to {max}{Suffix(unit)}]"),
            DefaultValueFactory = _ => standard,
            CustomParser = result => Parse(result, name, min, max, unit),
        };
    }

    /// <summary>Creates an option without a default. Its value is null if it is not given.</summary>
    public static Option<T?> CreateOptional<T>(string name, string description, T min, T max, string unit)
        where T : struct, INumber<T>
    {
        return new Option<T?>(name)
        {
            Description = Invariant($"{description} [{min} to {max}{Suffix(unit)}]"),
            CustomParser = result => Parse(result, name, min, max, unit),
        };
    }

    /// <summary>Creates an option that takes several numbers, also if it is repeated. Its value is empty if it is not given.</summary>
    public static Option<T[]> CreateList<T>(string name, string description, T min, T max, string unit)
        where T : INumber<T>
    {
        return new Option<T[]>(name)
        {
            Description = Invariant($"{description} [{min} to {max}{Suffix(unit)}]"),
            AllowMultipleArgumentsPerToken = true,
            DefaultValueFactory = _ => [],
            CustomParser = result => [.. result.Tokens.Select(token => Parse(result, token.Value, name, min, max, unit))],
        };
    }

    static T Parse<T>(ArgumentResult result, string name, T min, T max, string unit)
        where T : INumber<T> => Parse(result, result.Tokens.Count == 1 ? result.Tokens[0].Value : "", name, min, max, unit);

    static T Parse<T>(ArgumentResult result, string text, string name, T min, T max, string unit)
        where T : INumber<T>
    {
        var allowed = Invariant($"allowed: {min} to {max}{Suffix(unit)}.");
        // Parses as a double first, so that a number too large for the type counts as out of range instead of invalid.
        if (!double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number))
            result.AddError(OptionMessages.NotANumber(name, text, allowed));
        else if (!(number >= double.CreateChecked(min) && number <= double.CreateChecked(max)))
            result.AddError(OptionMessages.OutOfRange(name, text, Suffix(unit), allowed));
        else if (T.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var value))
            return value;
        else
            result.AddError(OptionMessages.NotWhole(name, text, allowed));
        return min;
    }

    static string Suffix(string unit) => unit.Length == 0 ? "" : " " + unit;

    static string Invariant(FormattableString text) => FormattableString.Invariant(text);
}
