using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Latency;
using Nowpose.Sync;

namespace Nowpose.Cli;

/// <summary><c>--estimator</c> and <c>--profile</c>: options for the runtime that several commands share.</summary>
static class RuntimeOptions
{
    public static Option<string> Estimator() => ChoiceOption.Create(
        "--estimator", "Clock estimator; ransac is the paper's", ClockEstimators.Default, [.. ClockEstimators.Names]);

    /// <param name="effect">Values of the profile that the command uses.</param>
    public static Option<string> Profile(string effect) => TextOption.Create(
        "--profile", "Latency profile created by calibrate; sets " + effect, "FILE.json");

    /// <summary>Reads the latency profile.</summary>
    /// <param name="given">Other options that set the display latency.</param>
    /// <returns>The profile; null if the option was not given.</returns>
    /// <exception cref="InputException">The file is not a readable profile, or another option sets the display latency, too.</exception>
    public static LatencyProfile ProfileOf(ParseResult parsed, Option<string> profile, params Option[] given)
    {
        if (parsed.GetValue(profile) is not { } path) return null;
        if (Array.Find(given, parsed.IsGiven) is { } other)
            throw new InputException(OptionValueMessages.TwoLatencies(other.Name));
        return LatencyProfileFile.Load(path);
    }
}
