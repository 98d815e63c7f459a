using Nowpose.Cli;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>One run of the command line in this process, with what it printed.</summary>
sealed record CliRun(int ExitStatus, string Output, string Errors)
{
    public static async Task<CliRun> OfAsync(params string[] args)
    {
        var (status, output, errors) = await CapturedConsole.OfAsync(() => CommandLine.RunAsync(args));
        return new CliRun(status, output, errors);
    }

    public string[] Lines => CapturedConsole.Lines(Output);
}
