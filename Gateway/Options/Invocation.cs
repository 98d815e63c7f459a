using System.CommandLine;
using System.CommandLine.Help;

namespace Nowpose.Gateway.Options;

/// <summary>How every program here runs a command: bad input is one line on stderr and exit 2, a failure 1, Ctrl-C 130.</summary>
public static class Invocation
{
    /// <summary>The command above all verbs, called by the program's own name whatever its file is called.</summary>
    public static Command Root(string program, string description, params Command[] verbs)
    {
        var root = new Command(program, description) { new HelpOption { Recursive = true }, new VersionOption() };
        foreach (var verb in verbs) root.Subcommands.Add(verb);
        return root;
    }

    /// <param name="root">What <see cref="Root"/> made; its name stands before each complaint.</param>
    /// <param name="args">As typed.</param>
    /// <param name="whenTerminated">The status after a request to end that is no Ctrl-C, as a service manager sends it.</param>
    /// <param name="complete">Adds to the arguments what else was configured; null for nothing.</param>
    /// <param name="place">Says of a complaint about something configured where that stands; null for as it is.</param>
    /// <returns>The exit status; never throws for what the user typed or gave.</returns>
    public static async Task<int> RunAsync(
        Command root, string[] args, int whenTerminated = ExitStatus.Terminated,
        Func<Command, string[], string[]> complete = null, Func<string, string> place = null)
    {
        var program = root.Name;
        place ??= complaint => complaint;
        using var end = new EndRequest();
        try
        {
            var parsed = root.Parse(complete == null ? args : complete(root, args));
            if (parsed.Errors.Count > 0 && parsed.Action is not HelpAction)
                return Fail(program, ExitStatus.BadInput, Complaint(parsed) + " See --help.");
            // Null: the library's own handling of signals, which ends with the same status whatever the signal was, stays out of it.
            var configuration = new InvocationConfiguration { EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null };
            return await parsed.InvokeAsync(configuration, end.Token);
        }
        catch (WrongEntriesException bad)
        {
            foreach (var line in bad.Lines) Fail(program, ExitStatus.BadInput, place(line));
            return ExitStatus.BadInput;
        }
        catch (InputException bad)
        {
            return Fail(program, ExitStatus.BadInput, place(bad.Message));
        }
        catch (OperationCanceledException)
        {
            return end.IsInterrupt ? ExitStatus.Interrupted : whenTerminated;
        }
        catch (Exception failure)
        {
            return Fail(program, ExitStatus.Failed, place(failure.Message));
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
