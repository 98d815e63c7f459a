using System.CommandLine;

namespace Nowpose.Cli;

/// <summary>The command line as a whole: which verbs there are, and what becomes of bad input.</summary>
public static class CommandLine
{
    const string DefaultVerb = "demo";

    /// <summary>Runs one command and returns the exit status; never throws for what the user typed or gave.</summary>
    public static async Task<int> RunAsync(string[] args)
    {
        var root = Root();
        var parsed = root.Parse(WithVerb(args, root));
        if (parsed.Errors.Count > 0 && parsed.Action is not System.CommandLine.Help.HelpAction)
            return Fail(ExitStatus.BadInput, parsed.Errors[0].Message + " See --help.");
        return await InvokeAsync(parsed);
    }

    static RootCommand Root()
    {
        var root = new RootCommand("nowpose: shows a moving robot where it is, not where it was. Without a verb: demo.");
        foreach (var verb in Verbs())
            root.Subcommands.Add(verb);
        return root;
    }

    static IEnumerable<Command> Verbs()
    {
        yield return Demo.DemoVerb.Create();
        yield return Replay.ReplayVerb.Create();
        yield return Sync.SyncVerb.Create();
        yield return Kinematics.KinematicsVerb.Create();
    }

    static async Task<int> InvokeAsync(ParseResult parsed)
    {
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

    static string[] WithVerb(string[] args, RootCommand root)
    {
        var asksForVerb = args.Length == 0
            || (args[0].StartsWith('-') && args[0] is not ("--help" or "-h" or "-?" or "--version"));
        return asksForVerb && root.Subcommands.Any(verb => verb.Name == DefaultVerb) ? [DefaultVerb, .. args] : args;
    }

    static int Fail(int status, string message)
    {
        Console.Error.WriteLine("nowpose: " + message.ReplaceLineEndings(" "));
        return status;
    }
}
