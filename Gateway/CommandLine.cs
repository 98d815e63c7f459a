using System.CommandLine;
using Nowpose.Cli;
using Nowpose.Gateway.Verbs;

namespace Nowpose.Gateway;

/// <summary>The gateway's own command line: which verbs there are, and what becomes of bad input.</summary>
public static class CommandLine
{
    /// <summary>Runs one command until it ends or Ctrl-C, and returns the exit status; never throws for what the user gave.</summary>
    public static async Task<int> RunAsync(string[] args)
    {
        var parsed = Root().Parse(args);
        if (parsed.Errors.Count > 0 && parsed.Action is not System.CommandLine.Help.HelpAction)
            return Fail(ExitStatus.BadInput, Complaint(parsed) + " See --help.");
        try
        {
            return await parsed.InvokeAsync(new InvocationConfiguration { EnableDefaultExceptionHandler = false });
        }
        catch (InputException bad)
        {
            return Fail(ExitStatus.BadInput, bad.Message);
        }
        catch (OperationCanceledException)
        {
            return ExitStatus.Interrupted;
        }
        catch (Exception failure)
        {
            return Fail(ExitStatus.Failed, failure.Message);
        }
    }

    static RootCommand Root()
    {
        var root = new RootCommand("nowpose-gateway: clock sync and joint positions for headsets. Ends with Ctrl-C.");
        root.Subcommands.Add(PlantVerb.Simulate());
        root.Subcommands.Add(PlantVerb.Replay());
        root.Subcommands.Add(ServeVerb.Create());
        return root;
    }

    // An option that is not known comes after "no command" in the list, but is what went wrong.
    static string Complaint(ParseResult parsed) =>
        parsed.UnmatchedTokens.Count > 0 ? $"'{parsed.UnmatchedTokens[0]}' is not known." : parsed.Errors[0].Message;

    static int Fail(int status, string message)
    {
        Console.Error.WriteLine("nowpose-gateway: " + message.ReplaceLineEndings(" "));
        return status;
    }
}
