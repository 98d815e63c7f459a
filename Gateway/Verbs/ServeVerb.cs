using System.CommandLine;
using System.CommandLine.Parsing;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Configuration;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Verbs;

/// <summary>The command "serve", which starts a gateway for sources that connect to it.</summary>
static class ServeVerb
{
    const string Monotonic = "monotonic", System = "system";

    public static Command Create(ConfiguredArguments configured)
    {
        var server = new ServerArguments(configured);
        var robot = TextOption.Create(
            "--robot", $"Robot description for headsets: {RobotFiles.Names} or the path of a .urdf file [default: a source sends it]", "ROBOT");
        var controlClock = TextOption.Create(
            "--clock", "Control clock: the name of a plant's clock, or own for the gateway's clock [default: the first clock that an adapter offers]",
            "NAME");
        controlClock.Validators.Add(CheckClock);
        var ownClock = ChoiceOption.Create(
            "--own-clock",
            "The gateway's own clock: monotonic starts at Unix time and is never set; system follows all corrections of the system clock "
                + "(for sources that use it for their time stamps)",
            Monotonic, [Monotonic, System]);
        var plants = TextOption.CreateList(
            "--plant", "Configuration of a control system (.yaml), whose adapter starts with the gateway. Repeat for several control systems",
            "FILE");
        var stationary = TextOption.Create(
            "--stationary", "File of stationary objects (.json), saved by a headset or written by hand; the gateway publishes them on /tf_static",
            "FILE");
        var command = new Command("serve", "Serve the data of the sources that connect to the gateway");
        command.Options.Add(robot);
        command.Options.Add(controlClock);
        command.Options.Add(ownClock);
        command.Options.Add(plants);
        command.Options.Add(stationary);
        server.AddTo(command);
        command.SetAction(async (parsed, stop) =>
        {
            var name = parsed.GetValue(robot);
            var files = parsed.GetValue(plants) ?? [];
            var frames = parsed.GetValue(stationary);
            if (server.IsCheck(parsed))
            {
                await CheckAsync(
                    new Findings(configured.Wrong), server, parsed, parsed.GetValue(ownClock) == System, parsed.GetValue(controlClock), name, files, frames,
                    configured.AreKnown(robot, stationary, plants), stop);
                return;
            }

            var clock = server.Clock(parsed, parsed.GetValue(ownClock) == System);
            var (description, placed, options) = await Invocation.ReadAsync(
                () => (
                    name == null ? null : Describe(name), frames == null ? null : StationaryFrames.Load(frames),
                    server.Options(parsed) with { ControlClock = parsed.GetValue(controlClock) }),
                stop);
            AdapterProcesses.CheckAddress(files, options, options.Certificate != null);
            var read = await AdapterProcesses.CheckAsync(files, stop);
            options = options with
            {
                ExpectsSources = PlantFile.ExpectsJoints(read, description),
                ReservedClocks = [.. read.Where(plant => plant.OffersClock).Select(plant => plant.Name)],
            };
            foreach (var one in read) Announcement.Log(one.Summary);
            foreach (var warning in PlantFile.WarningsOf(read, options.ControlClock)) Announcement.Log(DryRunMessages.WarningLog(warning));
            if (PlantFile.MissingJoints(read, description) is { Count: > 0 } missing) Announcement.Log(DryRunMessages.MissingJointsLog(missing));
            if (PlantFile.MissingParents(read, description, placed) is { Count: > 0 } parents)
                Announcement.Log(DryRunMessages.MissingParentsLog(parents));
            // On Windows, the end of the certificate removes its key from the profile of the user.
            using var certificate = options.Certificate;
            await using var gateway = await GatewayServer.StartAsync(options, clock, Announcement.LogWithTime, stop);
            using var source = gateway.Hub.OpenSource();
            if (description != null) source.Describe(description);
            if (placed != null) StationaryFrames.Publish(frames, placed, source);
            if (server.Records(parsed)) gateway.Recorder.SwitchOn();
            Announcement.Write(gateway, clock, server.SkewPpm(parsed), name, null);
            await using var adapters = AdapterProcesses.Start(read, gateway);
            await Task.Delay(Timeout.Infinite, stop);
        });
        return command;
    }

    // isCellKnown: whether no error in the configuration file concerns the robot, the plants and the stationary objects.
    static async Task CheckAsync(
        Findings findings, ServerArguments server, ParseResult parsed, bool isSystemClock, string controlClock, string robot, string[] plants, string stationary,
        bool isCellKnown, CancellationToken stop)
    {
        var (description, placed) = await Invocation.ReadAsync(
            () =>
            {
                var options = server.Check(parsed, findings);
                if (server.IsEncryptionKnown) findings.Try(() => AdapterProcesses.CheckAddress(plants, options, server.Encrypts(parsed)));
                findings.Try(() => server.Clock(parsed, isSystemClock));
                var text = robot == null ? null : findings.Try(() => Describe(robot));
                if (text != null) findings.Good("robot", robot);
                return (text, stationary == null ? null : findings.Try(() => StationaryFrames.Load(stationary)));
            },
            stop);
        if (placed != null) findings.Good("stationary", $"{stationary} ({placed.Count} frames)");
        try
        {
            var read = await AdapterProcesses.CheckAsync(plants, stop);
            foreach (var good in read) findings.Good("plant", good.Summary);
            foreach (var warning in PlantFile.WarningsOf(read, controlClock)) findings.Good("warning", warning);
            // Otherwise, the robot or object that is not known may have the joint, frame or link.
            if (isCellKnown && (robot == null || description != null)) FindMissing(findings, read, description, placed, stationary == null || placed != null);
        }
        catch (InputException wrong)
        {
            findings.Try(() => throw wrong);
        }

        findings.Conclude();
    }

    // What is missing is not an error, because another client may publish it.
    static void FindMissing(Findings findings, IReadOnlyCollection<PlantFile> plants, string robot, TransformsMessage stationary, bool areFramesKnown)
    {
        if (PlantFile.MissingJoints(plants, robot) is { Count: > 0 } joints) findings.Good("missing_joints", DryRunMessages.MissingJoints(joints));
        if (areFramesKnown && PlantFile.MissingParents(plants, robot, stationary) is { Count: > 0 } parents)
            findings.Good("missing_parents", DryRunMessages.MissingParents(parents));
    }

    static void CheckClock(OptionResult result)
    {
        var name = result.Tokens.Count == 1 ? result.Tokens[0].Value : "";
        if (name != PlantClocks.Own && !PlantClocks.IsName(name))
            result.AddError(AddressOptionMessages.ClockName(name));
    }

    // Returns the text of the URDF. Also parses it, so that the command rejects an invalid file at startup.
    static string Describe(string robot)
    {
        RobotFiles.Load(robot, out var urdf);
        return urdf;
    }
}
