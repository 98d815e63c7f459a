using System.CommandLine;
using System.CommandLine.Help;

namespace Nowpose.Gateway.Options;

/// <summary>How every program here runs a command: bad input is one line on stderr and exit 2, a failure 1, Ctrl-C 130.</summary>
public static class Invocation
{
    /// <summary>Room to write what was measured so far after Ctrl-C.</summary>
    static readonly TimeSpan TimeToEnd = TimeSpan.FromSeconds(10);

    /// <summary>The command above all verbs, called by the program's own name whatever its file is called.</summary>
    public static Command Root(string program, string description, params Command[] verbs)
    {
        var root = new Command(program, description) { new HelpOption { Recursive = true }, new VersionOption() };
        foreach (var verb in verbs) root.Subcommands.Add(verb);
        return root;
    }

    /// <param name="root">What <see cref="Root"/> made; its name stands before each complaint.</param>
    /// <param name="args">As typed.</param>
    /// <returns>The exit status; never throws for what the user typed or gave.</returns>
    public static async Task<int> RunAsync(Command root, string[] args)
    {
        var parsed = root.Parse(args);
        var program = root.Name;
        if (parsed.Errors.Count > 0 && parsed.Action is not HelpAction)
            return Fail(program, ExitStatus.BadInput, Complaint(parsed) + " See --help.");
        try
        {
            var configuration = new InvocationConfiguration { EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = TimeToEnd };
            return await parsed.InvokeAsync(configuration);
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
    static string Complaint(ParseResult parsed)
    {
        if (parsed.UnmatchedTokens.Count == 0) return parsed.Errors[0].Message;
        var unknown = parsed.UnmatchedTokens[0];
        var isVerb = parsed.RootCommandResult.Command.Subcommands.Any(verb => verb.Name == unknown);
        return isVerb ? $"'{unknown}' comes too late: the verb stands first." : $"'{unknown}' is not known.";
    }

    static int Fail(string program, int status, string message)
    {
        Console.Error.WriteLine(program + ": " + message.ReplaceLineEndings(" "));
        return status;
    }
}
