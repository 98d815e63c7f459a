using System.CommandLine;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Gateway.Plants;

namespace Nowpose.Gateway.Verbs;

/// <summary>The command "replay", which starts a gateway with a recorded motion.</summary>
static class ReplayVerb
{
    public static Command Create(ConfiguredArguments configured)
    {
        var file = new Argument<string>("FILE") { Description = "Recorded motion, .csv or .csv.gz: the time in s and one column for each joint" };
        var command = new Command("replay", "Serve a recorded motion, played forward and backward");
        command.Arguments.Add(file);
        return PlantCommand.Complete(configured, command, parsed =>
        {
            var recording = MotionRecording.Read(parsed.GetValue(file));
            return robot => new RecordedMotion(recording, robot);
        });
    }
}
