using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Verbs;

namespace Nowpose.Gateway;

/// <summary>The gateway's own command line.</summary>
public static class CommandLine
{
    /// <summary>Runs one command until it ends or Ctrl-C, and returns the exit status; never throws for what the user gave.</summary>
    public static Task<int> RunAsync(string[] args)
    {
        var root = Invocation.Root(
            "nowpose-gateway", "Clock sync and joint positions for headsets. Ends with Ctrl-C.",
            PlantVerb.Simulate(), PlantVerb.Replay(), ServeVerb.Create(),
            CellVerb.Create(), PairVerb.Create(), PairingsVerb.Create());
        var configured = new ConfiguredArguments();
        // Asked to end by whoever started it as a service, it has done what it should.
        return Invocation.RunAsync(root, args, ExitStatus.Done, configured.Of, configured.Place);
    }
}
