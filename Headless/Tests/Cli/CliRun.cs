using Nowpose.Cli;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>One run of the command line in this process, with what it printed. The console is one: runs take turns.</summary>
sealed record CliRun(int ExitStatus, string Output, string Errors)
{
    static readonly SemaphoreSlim Console_ = new(1);

    public static async Task<CliRun> OfAsync(params string[] args)
    {
        await Console_.WaitAsync();
        var (output, errors) = (Console.Out, Console.Error);
        using var captured = new StringWriter();
        using var capturedErrors = new StringWriter();
        try
        {
            Console.SetOut(captured);
            Console.SetError(capturedErrors);
            var status = await CommandLine.RunAsync(args);
            return new CliRun(status, captured.ToString(), capturedErrors.ToString());
        }
        finally
        {
            Console.SetOut(output);
            Console.SetError(errors);
            Console_.Release();
        }
    }

    public string[] Lines => Output.Split('\n', StringSplitOptions.RemoveEmptyEntries);
}
