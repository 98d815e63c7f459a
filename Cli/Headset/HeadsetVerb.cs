using System.CommandLine;
using System.Net;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Protocol;

namespace Nowpose.Cli.Headset;

/// <summary><c>headset</c>: checks whether a gateway and its plant are suitable for headsets. Needs no headset.</summary>
static class HeadsetVerb
{
    static readonly Option<string> Host = TextOption.Create("--host", "Name or address of the gateway", standard: "127.0.0.1");
    static readonly Option<int> SyncPort = NumberOption.Create(
        "--sync-port", "TCP port of the clock synchronisation", ProtocolLimits.SyncPort, 1, IPEndPoint.MaxPort, "");
    static readonly Option<int> WebSocketPort = NumberOption.Create(
        "--ws-port", "TCP port of the joint positions", ProtocolLimits.WebSocketPort, 1, IPEndPoint.MaxPort, "");
    static readonly Option<string> Pin = TextOption.Create(
        "--pin", "Pin of the gateway's certificate, as printed by the gateway; encrypts both connections", "PIN");
    static readonly Option<string> TokenFile = TextOption.Create("--token-file", "File that contains only the token of an observer", "FILE");
    static readonly Option<bool> InsecureLan = SwitchOption.Create(
        "--insecure-lan", "Allow unencrypted connections to another machine; use only on a trusted network");
    static readonly Option<string> Name = TextOption.Create("--name", "Name of this headset", standard: "headless");
    static readonly Option<string> Robot = TextOption.Create("--robot", RobotFiles.Names + " or a .urdf file [default: as the gateway describes it]");
    static readonly Option<string> Namespace = TextOption.Create(
        "--namespace", "Namespace of the robot, for a gateway with several robots, for example arm1 [default: the robot without a namespace]",
        "NAME");
    static readonly Option<string> Predictor = PredictorOption.Create();
    static readonly Option<string> Estimator = RuntimeOptions.Estimator();
    static readonly Option<string> Profile = RuntimeOptions.Profile(
        "the display latency; nothing is rendered, so its render time limit has no effect");
    static readonly Option<double> Visualisation = NumberOption.Create("--visu-ms", "Display latency that the runtime uses", 40.0, 0, 500, "ms");
    static readonly Option<double> FramesPerSecond = NumberOption.Create("--fps", "Frames per second", 60.0, 1, 240, "Hz");
    static readonly Option<double> Seconds = NumberOption.Create(
        "--seconds", "Duration of the run; without --robot, it begins with the gateway's description of the robot, for which it waits up to 10 s", 20.0,
        1, 86_400, "s");
    static readonly Option<string> Record = TextOption.Create(
        "--record", "File for a recording of the session, .jsonl; the exit status is 1 if it is incomplete", "FILE");
    static readonly Option<double> RecordMegabytes = NumberOption.Create(
        "--record-max-mb", "Maximum size of the recording, which ends at this size", HeadsetSettings.DefaultRecordingMegabytes, 0.001, 100_000, "MB");
    static readonly Option<bool> Json = SwitchOption.Create("--json", "Print the result as JSON");

    public static Command Create()
    {
        var verb = new Command(
            "headset", "Connect the headset runtime to a running gateway, and report accuracy and latency. The exit status is 1 if the "
            + "pose was current for less than half of the run, from its start.")
        {
            Host, SyncPort, WebSocketPort, Pin, TokenFile, InsecureLan, Name, Robot, Namespace, Predictor, Estimator, Profile, Visualisation,
            FramesPerSecond, Seconds, Record, RecordMegabytes, Json,
        };
        verb.SetAction(async (parsed, cancel) =>
        {
            var settings = await Invocation.ReadAsync(() => Settings(parsed), cancel);
            return await Task.Factory.StartNew(
                () => Run(settings, parsed.GetValue(Json), cancel),
                // Runs on a separate thread, like a headset's frame loop. The run handles the cancellation itself and prints the results so far.
                CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        });
        return verb;
    }

    internal static int Run(HeadsetSettings settings, bool isJson, CancellationToken cancel)
    {
        var run = new HeadsetRun(settings, line => Console.Error.WriteLine(line));
        var result = default(HeadsetResult);
        ConsoleProgress.Run(settings.Seconds, report => result = run.Play(report, cancel));
        if (isJson) Console.Out.WriteLine(result.Json());
        else HeadsetTable.Print(result, ResultConsole.Create());
        foreach (var note in run.Notes) Console.Error.WriteLine(ConsoleMessages.Line(note));
        if (run.RecordingFault != null) Console.Error.WriteLine(ConsoleMessages.Line(run.RecordingFault));
        if (cancel.IsCancellationRequested) return ExitStatus.Interrupted;
        if (run.WhyFailed != null) Console.Error.WriteLine(ConsoleMessages.Line(run.WhyFailed));
        return run.HasFailed ? ExitStatus.Failed : ExitStatus.Done;
    }

    static HeadsetSettings Settings(ParseResult parsed)
    {
        return new HeadsetSettings
        {
            Connection = HeadsetConnection.Of(
                parsed.GetValue(Host), parsed.GetValue(SyncPort), parsed.GetValue(WebSocketPort), parsed.GetValue(Pin), parsed.GetValue(TokenFile),
                parsed.GetValue(InsecureLan), parsed.GetValue(Name)),
            Robot = parsed.GetValue(Robot) is string robot ? RobotFiles.Load(robot) : null,
            RobotNamespace = NamespaceOf(parsed.GetValue(Namespace)),
            Predictor = parsed.GetValue(Predictor),
            Estimator = parsed.GetValue(Estimator),
            Profile = RuntimeOptions.ProfileOf(parsed, Profile, Visualisation),
            Visualisation = new VisualisationLatency(TimeSpan.FromMilliseconds(parsed.GetValue(Visualisation))),
            Seconds = parsed.GetValue(Seconds),
            FramesPerSecond = parsed.GetValue(FramesPerSecond),
            RecordingPath = RecordingPathOf(parsed),
            RecordingMegabytes = parsed.GetValue(RecordMegabytes),
        };
    }

    // The commands that read a recording would take it for a compressed file or for a motion.
    static string RecordingPathOf(ParseResult parsed)
    {
        var given = parsed.GetValue(Record);
        if (given == null && parsed.IsGiven(RecordMegabytes)) throw new InputException(HeadsetMessages.MaximumWithoutRecording);
        return Path.GetExtension(given)?.ToLowerInvariant() is ".gz" or ".csv" ? throw new InputException(HeadsetMessages.RecordingName(given)) : given;
    }

    static string NamespaceOf(string given) => given == null || RobotTopic.IsNamespace(given)
        ? given ?? "" : throw new InputException(HeadsetMessages.NamespaceInvalid(given, ProtocolLimits.NamespaceLength));
}
