using System.CommandLine;
using Nowpose.Gateway.Configuration;
using Nowpose.Motion;

namespace Nowpose.Gateway.Verbs;

/// <summary>The command "simulate", which starts a gateway with a simulated robot cell.</summary>
static class SimulateVerb
{
    public static Command Create(ConfiguredArguments configured) => PlantCommand.Complete(
        configured, new Command("simulate", "Serve a simulated robot that picks and places"), _ => robot => new PickAndPlaceMotion(robot), mayHaveSeveral: true);
}
