using System.CommandLine;
using System.CommandLine.Help;

namespace Nowpose.Gateway.Options;

/// <summary>
/// Runs a command of a program and returns its exit status. Invalid input gives one line on stderr and status 2, a failure status 1,
/// Ctrl-C status 130, and another request to end the status of the program for it.
/// </summary>
public static class Invocation
{
    /// <summary>Creates the root command. Its name is the program's name, even if the executable file has another name.</summary>
    public static Command Root(string program, string description, params Command[] commands)
    {
        var root = new Command(program, description) { new HelpOption { Recursive = true }, new VersionOption() };
        foreach (var command in commands) root.Subcommands.Add(command);
        return root;
    }

    /// <summary>Parses arguments as they are. One that begins with @ is the name of a file or folder, not a file with more arguments.</summary>
    public static ParseResult Parse(Command root, IReadOnlyList<string> args) =>
        root.Parse(args, new ParserConfiguration { ResponseFileTokenReplacer = null });

    /// <param name="root">The command from <see cref="Root"/>. Its name precedes each error message.</param>
    /// <param name="args">The arguments of the command line.</param>
    /// <param name="whenTerminated">Exit status after a request to end other than Ctrl-C, for example by a service manager.</param>
    /// <param name="complete">Adds arguments from a configuration file; null without such a file.</param>
    /// <param name="place">Adds the place in the configuration file to an error message; null to leave messages unchanged.</param>
    /// <param name="cancel">Has the effect of Ctrl-C.</param>
    /// <returns>The exit status. Does not throw for invalid user input.</returns>
    public static async Task<int> RunAsync(
        Command root, string[] args, int whenTerminated = ExitStatus.Terminated,
        Func<Command, string[], string[]> complete = null, Func<string, string> place = null, CancellationToken cancel = default)
    {
        var program = root.Name;
        place ??= complaint => complaint;
        using var end = new EndRequest(cancel);
        try
        {
            if (OptionWithoutValue(root, args) is { } option) return Fail(program, ExitStatus.BadInput, OptionMessages.ValueMissing(option));
            var parsed = Parse(root, complete == null ? args : await ReadAsync(() => complete(root, args), end.Token));
            if (parsed.UnmatchedTokens.Count > 0 || (parsed.Errors.Count > 0 && parsed.Action is not HelpAction))
                return Fail(program, ExitStatus.BadInput, Complaint(parsed));
            // A null timeout disables the library's signal handling, which returns the same status for every signal.
            var configuration = new InvocationConfiguration { EnableDefaultExceptionHandler = false, ProcessTerminationTimeout = null };
            var status = await parsed.InvokeAsync(configuration, end.Token);
            // The result of an interrupted command is partial, even if the command has written it. The command does not know the kind of the request.
            return end.Token.IsCancellationRequested && status is ExitStatus.Done or ExitStatus.Interrupted ? Ended() : status;
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
            return Ended();
        }
        catch (Exception failure) when (GuardedConsole.IsClosedPipe(failure))
        {
            return ExitStatus.Failed;
        }
        catch (Exception failure)
        {
            return Fail(program, ExitStatus.Failed, place(failure.Message));
        }

        int Ended() => end.IsInterrupt ? ExitStatus.Interrupted : whenTerminated;
    }

    /// <summary>
    /// Runs the part of a command that reads its input. Ctrl-C ends the command at once also while this part cannot end itself, for example because a
    /// file does not end.
    /// </summary>
    /// <exception cref="OperationCanceledException">The user cancelled the command.</exception>
    public static async Task<T> ReadAsync<T>(Func<T> read, CancellationToken cancel)
    {
        var result = await Task.Run(read, CancellationToken.None).WaitAsync(cancel);
        cancel.ThrowIfCancellationRequested();
        return result;
    }

    // The library takes an option that follows, even an unknown one, as the value, which only --name=--value should mean.
    static string OptionWithoutValue(Command root, string[] args)
    {
        Option[] options = [.. Parse(root, args).CommandResult.Command.Options, .. root.Options.Where(option => option.Recursive)];
        for (var i = 0; i < args.Length && args[i] != "--"; i++)
        {
            if (Find(args[i]) is not { Arity.MinimumNumberOfValues: > 0 }) continue;
            var name = NameIn(args[i]);
            var isJoined = name.Length < args[i].Length;
            var value = isJoined ? args[i][(name.Length + 1)..] : args.ElementAtOrDefault(i + 1) ?? "";
            if (value.Length == 0 || (!isJoined && (value.StartsWith("--", StringComparison.Ordinal) || Find(value) != null))) return name;
        }

        return null;

        Option Find(string arg) => Array.Find(options, option => option.Name == NameIn(arg) || option.Aliases.Contains(NameIn(arg)));
    }

    // The name and its value may be one argument.
    static string NameIn(string arg) => arg.Split('=', ':')[0];

    // Prefers the error about an unknown command. The library lists it after the error that no command was given.
    static string Complaint(ParseResult parsed)
    {
        if (parsed.UnmatchedTokens.Count == 0) return OptionMessages.SeeHelp(parsed.Errors[0].Message);
        var unknown = parsed.UnmatchedTokens[0];
        var isCommand = parsed.RootCommandResult.Command.Subcommands.Any(command => command.Name == unknown);
        return isCommand ? OptionMessages.SeeHelp(OptionMessages.CommandFirst(unknown)) : OptionMessages.UnknownArgument(unknown);
    }

    static int Fail(string program, int status, string message)
    {
        Console.Error.WriteLine(program + ": " + message.ReplaceLineEndings(" "));
        return status;
    }
}
