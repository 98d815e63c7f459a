using System.CommandLine;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Motion;
using Nowpose.Simulation.Work;

namespace Nowpose.Gateway.Verbs;

/// <summary>The common part of the commands "simulate" and "replay", which start a gateway with its own robot cell.</summary>
static class PlantCommand
{
    /// <summary>Completes a command: adds its options and its action.</summary>
    /// <param name="configured">The entries of the configuration file.</param>
    /// <param name="motionOf">Reads the motion that the arguments select, and returns the function that creates it for a robot.</param>
    /// <param name="mayHaveSeveral">Whether the command can serve several robots.</param>
    public static Command Complete(
        ConfiguredArguments configured, Command command, Func<ParseResult, Func<RobotModel, IMotion>> motionOf, bool mayHaveSeveral = false)
    {
        var server = new ServerArguments(configured);
        var plant = new PlantArguments();
        plant.AddTo(command, mayHaveSeveral);
        server.AddTo(command);
        command.SetAction(async (parsed, stop) =>
        {
            if (server.IsCheck(parsed))
            {
                var findings = await Invocation.ReadAsync(
                    () =>
                    {
                        var found = new Findings(configured.Wrong);
                        server.Check(parsed, found);
                        var motionFor = found.Try(() => motionOf(parsed));
                        // If the entry is invalid, the motion would be compared with the default robot.
                        var model = configured.AreKnown(plant.RobotOption) ? found.Try(() => RobotFiles.Load(plant.Robot(parsed), out _)) : null;
                        if (motionFor != null && model != null) found.Good("warning", found.Try(() => WarningOf(motionFor(model))));
                        if (model != null) found.Good("robot", plant.Robot(parsed));
                        return found;
                    },
                    stop);
                findings.Conclude();
                return;
            }

            var (robot, urdf, motion, options) = await Invocation.ReadAsync(
                () =>
                {
                    var model = RobotFiles.Load(plant.Robot(parsed), out var text);
                    return (model, text, motionOf(parsed)(model), server.Options(parsed));
                },
                stop);
            if (WarningOf(motion) is { } warning) Announcement.Log(DryRunMessages.WarningLog(warning));
            var clock = server.Clock(parsed);
            // On Windows, the end of the certificate removes its key from the profile of the user.
            using var certificate = options.Certificate;
            await using var gateway = await GatewayServer.StartAsync(
                options with { ControlClock = PlantClocks.Own }, clock, Announcement.LogWithTime, stop);
            // A recorded motion does not contain the moves in which the gripper closes and opens.
            var motions = motion is PickAndPlaceMotion moves
                ? new CellMotion(new CellWork(robot, moves, plant.Robots(parsed))) : new CellMotion(motion);
            using var source = gateway.Hub.OpenSource();
            foreach (var (name, _) in motions.Motions) source.Describe(urdf, name);
            if (server.Records(parsed)) gateway.Recorder.SwitchOn();
            using var cell = new SimulatedCell(motions, clock, plant.Timing(parsed), plant.Seed(parsed), plant.PublishesPlan(parsed));
            cell.PublishInto(gateway.Hub);
            Announcement.Write(gateway, clock, server.SkewPpm(parsed), plant.Robot(parsed), cell);
            await Task.Delay(Timeout.Infinite, stop);
        });
        return command;
    }

    static string WarningOf(IMotion motion) => (motion as RecordedMotion)?.Warning;
}
