namespace Nowpose.Gateway.Messages;

/// <summary>Error messages about options, with the allowed values.</summary>
static class OptionMessages
{
    public static string UnknownChoice(string option, string value, string allowed) => $"{option}: '{value}' is unknown; allowed: {allowed}.";
    public static string ValueMissing(string option) => $"{option}: value missing; see --help.";
    public static string UnknownArgument(string argument) => $"'{argument}' is unknown; see --help.";
    public static string SeeHelp(string error) => $"{error} See --help.";
    public static string CommandFirst(string command) => $"'{command}' must be the first argument, because it is a command.";
    public static string NotANumber(string option, string value, string allowed) => $"{option}: '{value}' is not a number; {allowed}";

    public static string OutOfRange(string option, string value, string suffix, string allowed) =>
        $"{option}: {value}{suffix} is out of range; {allowed}";

    public static string NotWhole(string option, string value, string allowed) => $"{option}: '{value}' is not a whole number; {allowed}";

    public static string NotARange(string option, string value, double maxMs) =>
        FormattableString.Invariant($"{option}: '{value}' is not a range; allowed: one number or MIN-MAX with 0 <= MIN <= MAX <= {maxMs} ms.");
}
