using Nowpose.Messages;

namespace Nowpose.Cli.Messages;

/// <summary>Error messages about invalid values of options that several commands use.</summary>
static class OptionValueMessages
{
    public static string Limits(string option, string value) =>
        $"{option}: '{value}' is not three numbers from 1 to 1e9, separated by commas, for example 1000,5000,50000.";

    public static string NotCompressed(string option, string path) => $"{option}: {path} is written without compression; use a name without .gz";

    public static string NotABox(string option, string text, int minSide, int maxSide) =>
        $"{option}: '{text}' is not a box; allowed: X,Y,WIDTH,HEIGHT in whole px, sides {minSide} to {maxSide} px.";

    public static string UnknownPredictor(string option, string value, string allowed) =>
        $"{option}: {PredictionMessages.UnknownPredictor(value, allowed)}.";

    public static string WouldOverwriteInput(string option, string path) =>
        $"{option}: {path} is an input of this command and would be overwritten; use another name";

    public static string TwoLatencies(string option) => $"--profile and {option} both set the display latency; use one of them";
}
