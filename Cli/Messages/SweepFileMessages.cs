namespace Nowpose.Cli.Messages;

/// <summary>Error messages about the log of a load sweep.</summary>
static class SweepFileMessages
{
    public static string Header(string file, int line, string header, string expected) =>
        $"{file}:{line}: the header is '{header}'; it must be {expected}";

    public static string NoRows(string file) => $"{file}: no rows below the header; a sweep log has one row for each frame; sweep again";
    public static string FieldCount(string place, int fields, int expected) => $"{place}: the row has {fields} fields; it must have {expected}";

    public static string UnknownSource(string field, string text, string allowed) =>
        $"{field}: '{text}' is not a source of render times; allowed: {allowed}, or an empty field";

    public static string NotWhole(string field, string text, string unit) =>
        $"{field}: '{text}' is not a whole number of {unit}; correct it, or sweep again";
    public static string NotANumber(string field, string text, string unit) =>
        $"{field}: '{text}' is not a number of {unit}; use a point as the decimal separator";

    public static string TwoHeadsets(string place, string device, string other) =>
        $"{place}: frames of '{device}' and of '{other}'; a sweep must be from one headset: keep the rows of one";

    public static string TwoRates(string place, double hertz, double otherHertz) =>
        FormattableString.Invariant($"{place}: frames at {hertz} Hz and at {otherHertz} Hz; L_visu depends on the rate: keep the rows of ")
        + "one rate";
}
