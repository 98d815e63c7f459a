using System.CommandLine;

namespace Nowpose.Cli.Replay;

/// <summary>Rejects options that conflict with another option, or with a recorded session, which defines sampling, latency and frames.</summary>
static class RecordingOptions
{
    /// <exception cref="InputException">One of the options was given.</exception>
    public static void RequireUnsetForSession(ParseResult parsed, string path, params Option[] options) =>
        RequireUnset(parsed, ReplayMessages.InSession(path), options);

    /// <param name="why">The reason, which follows the option's name in the message.</param>
    /// <exception cref="InputException">One of the options was given.</exception>
    public static void RequireUnset(ParseResult parsed, string why, params Option[] options)
    {
        foreach (var option in options)
            if (parsed.IsGiven(option))
                throw new InputException($"{option.Name}: {why}");
    }
}
