using System.CommandLine;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Verbs;

namespace Nowpose.Gateway;

/// <summary>The gateway's own command line.</summary>
public static class CommandLine
{
    /// <summary>Creates the root command with all commands.</summary>
    /// <param name="configured">Adds the entries of a configuration file to the arguments.</param>
    internal static Command Create(ConfiguredArguments configured) => Invocation.Root(
        "nowpose-gateway", "Serves the control time and joint positions to headsets. Stop it with Ctrl-C.",
        SimulateVerb.Create(configured), ReplayVerb.Create(configured), ServeVerb.Create(configured),
        CellVerb.Create(), PairVerb.Create(), PairingsVerb.Create());

    /// <summary>Runs one command until it ends or the user presses Ctrl-C. Does not throw for invalid user input.</summary>
    /// <returns>The exit status.</returns>
    public static Task<int> RunAsync(string[] args)
    {
        var configured = new ConfiguredArguments();
        // Exit status Done, because termination by the service manager is a normal end.
        return Invocation.RunAsync(Create(configured), args, ExitStatus.Done, configured.Of, configured.Place);
    }
}
