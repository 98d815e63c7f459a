using System.CommandLine;

namespace Nowpose.Cli;

/// <summary>Distinguishes an option on the command line from its default.</summary>
static class GivenOption
{
    public static bool IsGiven(this ParseResult parsed, Option option) => parsed.GetResult(option) is { Implicit: false };
}
