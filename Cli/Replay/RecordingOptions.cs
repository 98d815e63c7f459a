using System.CommandLine;
using Nowpose.Cli.Messages;

namespace Nowpose.Cli.Replay;

/// <summary>Checks options that contradict another option, or a recorded session, which has its own sampling, latency and frames.</summary>
static class RecordingOptions
{
    /// <exception cref="InputException">One of them was given.</exception>
    public static void RequireUnsetForSession(ParseResult parsed, string path, params Option[] options) =>
        RequireUnset(parsed, ReplayMessages.InSession(path), options);

    /// <param name="why">The reason, appended to the option's name.</param>
    /// <exception cref="InputException">One of them was given.</exception>
    public static void RequireUnset(ParseResult parsed, string why, params Option[] options)
    {
        foreach (var option in options)
            if (IsGiven(parsed, option))
                throw new InputException($"{option.Name}: {why}");
    }

    public static bool IsGiven(ParseResult parsed, Option option) => parsed.GetResult(option) is { Implicit: false };
}
