using System.CommandLine;
using Nowpose.Motion;

namespace Nowpose.Gateway.Verbs;

/// <summary>The verb "simulate", which starts a gateway with a simulated robot cell.</summary>
static class SimulateVerb
{
    public static Command Create() => PlantCommand.Complete(
        new Command("simulate", "Serve a simulated robot that picks and places"), (_, robot) => new PickAndPlaceMotion(robot), mayHaveSeveral: true);
}
