namespace Nowpose.Cli.Messages;

/// <summary>Error messages about the log of a load sweep.</summary>
static class SweepFileMessages
{
    public static string UnknownSource(string field, string text, string allowed) =>
        $"{field}: '{text}' is not a source of render times; allowed: {allowed}, or an empty field";

    public static string TwoHeadsets(string device, string other) =>
        $"frames of '{device}' and of '{other}'; a sweep must be from one headset: keep the rows of one";

    public static string TwoRates(double hertz, double otherHertz) =>
        FormattableString.Invariant($"frames at {hertz} Hz and at {otherHertz} Hz; L_visu depends on the rate: keep the rows of ")
        + "one rate";
}
