using System.CommandLine;

namespace Nowpose.Cli.Replay;

/// <summary>Options that contradict a recorded session, which has its own sampling, latency and frames.</summary>
static class RecordingOptions
{
    /// <exception cref="InputException">One of them was given.</exception>
    public static void RequireUnset(ParseResult parsed, string path, params Option[] options)
    {
        foreach (var option in options)
            if (IsGiven(parsed, option))
                throw new InputException($"{option.Name}: a recorded session has its own; leave it out for {path}");
    }

    public static bool IsGiven(ParseResult parsed, Option option) => parsed.GetResult(option) is { Implicit: false };
}
