using System.CommandLine;

namespace Nowpose.Gateway.Options;

/// <summary>How every program here runs a command: bad input is one line on stderr and exit 2, a failure 1, Ctrl-C 130.</summary>
public static class Invocation
{
    /// <summary>Room to write what was measured so far after Ctrl-C.</summary>
    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(10);

    /// <param name="program">Named before each complaint.</param>
    /// <returns>The exit status; never throws for what the user typed or gave.</returns>
    public static async Task<int> RunAsync(ParseResult parsed, string program)
    {
        if (parsed.Errors.Count > 0 && parsed.Action is not System.CommandLine.Help.HelpAction)
            return Fail(program, ExitStatus.BadInput, Complaint(parsed) + " See --help.");
        try
        {
            return await parsed.InvokeAsync(new InvocationConfiguration { EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = TimeToEnd });
        }
        catch (InputException bad)
        {
            return Fail(program, ExitStatus.BadInput, bad.Message);
        }
        catch (OperationCanceledException)
        {
            return ExitStatus.Interrupted;
        }
        catch (Exception failure)
        {
            return Fail(program, ExitStatus.Failed, failure.Message);
        }
    }

    // What is not known comes after "no command" in the list of errors, but is what went wrong.
    static string Complaint(ParseResult parsed) =>
        parsed.UnmatchedTokens.Count > 0 ? $"'{parsed.UnmatchedTokens[0]}' is not known." : parsed.Errors[0].Message;

    static int Fail(string program, int status, string message)
    {
        Console.Error.WriteLine(program + ": " + message.ReplaceLineEndings(" "));
        return status;
    }
}
