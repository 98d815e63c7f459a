using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Verbs;

namespace Nowpose.Gateway;

/// <summary>The gateway's own command line.</summary>
public static class CommandLine
{
    /// <summary>Runs one command until it ends or the user presses Ctrl-C. Does not throw for invalid user input.</summary>
    /// <returns>The exit status.</returns>
    public static Task<int> RunAsync(string[] args)
    {
        var configured = new ConfiguredArguments();
        var root = Invocation.Root(
            "nowpose-gateway", "Serves the control time and joint positions to headsets. Stop it with Ctrl-C.",
            SimulateVerb.Create(configured), ReplayVerb.Create(configured), ServeVerb.Create(configured),
            MarkerCodeVerb.Create(), PairVerb.Create(), PairingsVerb.Create());
        // Exit status Done, because termination by the service manager is a normal end.
        return Invocation.RunAsync(root, args, ExitStatus.Done, configured.Of, configured.Place);
    }
}
