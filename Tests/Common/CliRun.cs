using System.Text.RegularExpressions;
using Nowpose.Cli;

namespace Nowpose.Tests.Common;

/// <summary>Runs the command line in this process and captures its exit status and output.</summary>
sealed record CliRun(int ExitStatus, string Output, string Errors)
{
    public static async Task<CliRun> OfAsync(params string[] args)
    {
        var (status, output, errors) = await CapturedConsole.OfAsync(() => CommandLine.RunAsync(args));
        return new CliRun(status, output, errors);
    }

    public string[] Lines => CapturedConsole.Lines(Output);

    /// <summary>Gets the lines on stderr, except progress lines, which appear only on a slow machine.</summary>
    public string[] Complaints =>
        [.. CapturedConsole.Lines(Errors).Where(line => !Regex.IsMatch(line, @"^\d+ (of \d+ )?(pictures|frames|events|estimates|runs)$"))];
}
