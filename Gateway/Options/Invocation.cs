using System.CommandLine;
using System.CommandLine.Help;
using Nowpose.Gateway.Messages;

namespace Nowpose.Gateway.Options;

/// <summary>Runs a command of any program here: invalid input gives one line on stderr and exit status 2, a failure 1, Ctrl-C 130.</summary>
public static class Invocation
{
    /// <summary>Creates the root command. It has the program's own name, even if the executable file is named differently.</summary>
    public static Command Root(string program, string description, params Command[] verbs)
    {
        var root = new Command(program, description) { new HelpOption { Recursive = true }, new VersionOption() };
        foreach (var verb in verbs) root.Subcommands.Add(verb);
        return root;
    }

    /// <param name="root">The command from <see cref="Root"/>. Its name precedes each error message.</param>
    /// <param name="args">The arguments of the command line.</param>
    /// <param name="whenTerminated">Exit status after a request to end other than Ctrl-C, for example by a service manager.</param>
    /// <param name="complete">Adds configured arguments; null for none.</param>
    /// <param name="place">Adds the place in the configuration to an error message; null to leave it unchanged.</param>
    /// <returns>The exit status. Never throws for invalid user input.</returns>
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
            // Null disables the library's signal handling, which ends with the same status for every signal.
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

    // An unknown command comes after "no command" in the list of errors, but is the actual error.
    static string Complaint(ParseResult parsed)
    {
        if (parsed.UnmatchedTokens.Count == 0) return parsed.Errors[0].Message;
        var unknown = parsed.UnmatchedTokens[0];
        var isVerb = parsed.RootCommandResult.Command.Subcommands.Any(verb => verb.Name == unknown);
        return isVerb ? OptionMessages.CommandFirst(unknown) : $"'{unknown}' is not known.";
    }

    static int Fail(string program, int status, string message)
    {
        Console.Error.WriteLine(program + ": " + message.ReplaceLineEndings(" "));
        return status;
    }
}
