using System.Diagnostics;
using System.Text.Json;
using System.Text.RegularExpressions;
using Nowpose.Cli.Messages;
using NUnit.Framework;
using Nowpose.Cli.Demo;
using Nowpose.Cli.Headset;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Latency.Profile;
using Nowpose.Messages;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Simulation.Work;
using Nowpose.Sync;
using static System.FormattableString;

namespace Nowpose.Headless.Tests.Cli;

[Parallelizable(ParallelScope.All), FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class HeadsetVerbTests
{
    [Test]
    public async Task Headset_GatewayWithAMovingRobot_ReportsTheAccuracy()
    {
        var control = new StopwatchControlClock(Gateways.Start);
        await using var gateway = await Gateways.StartAsync(clock: control);
        using var cell = Simulate(gateway);
        using var recording = new TemporaryFile("", ".jsonl");

        var (run, played) = await PlayAsync(gateway, AfterCurrentFrames(60), recording.Path);

        Assert.That(run.RecordingFault, Is.Null);
        using var document = JsonDocument.Parse(played.Json());
        var result = document.RootElement;
        Assert.That(result.GetProperty("robot").GetString(), Is.EqualTo(RobotFiles.Load("youbot").Name));
        Assert.That(result.GetProperty("samples").GetInt64(), Is.Positive);
        Assert.That(result.GetProperty("clock").GetProperty("state").GetString(), Is.EqualTo("synchronised").Or.EqualTo("coarse"), "on a busy machine");
        Assert.That(result.GetProperty("clock").GetProperty("error_bound_us").GetDouble(), Is.GreaterThan(1));
        // The cell's clock uses the same hardware counter as the headset's clock, so the true offset is known.
        var clock = result.GetProperty("clock");
        var at = clock.GetProperty("at_ns").GetInt64();
        var trueOffset = at - control.AtCount((long)((Int128)at * Stopwatch.Frequency / 1_000_000_000)).Nanoseconds;
        Assert.That(
            Math.Abs(clock.GetProperty("offset_ns").GetInt64() - trueOffset) / 1000.0,
            Is.LessThanOrEqualTo(clock.GetProperty("error_bound_us").GetDouble() + 1));
        Assert.That(clock.GetProperty("estimated_error_us").GetDouble(), Is.Positive);
        Assert.That(
            result.GetProperty("latency_ms").GetProperty("app_p50").GetDouble(), Is.GreaterThan(20 - clock.GetProperty("error_bound_us").GetDouble() / 1000));
        Assert.That(result.GetProperty("pose").GetProperty("current_share").GetDouble(), Is.GreaterThan(0));
        Assert.That(result.GetProperty("version_mismatch").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(result.GetProperty("stretches").EnumerateArray(), Is.Not.Empty);
        var frames = File.ReadLines(recording.Path).Where(line => line.Contains("\"kind\":\"frame\"")).Select(line => JsonDocument.Parse(line).RootElement).ToList();
        Assert.That(frames, Has.Count.GreaterThanOrEqualTo(60));
    }

    [Test]
    public async Task Headset_RecordingCannotBeOpened_FailsBeforeTheRun()
    {
        var run = await CliRun.OfAsync("headset", "--sync-port", "1", "--ws-port", "1", "--record", ImpossiblePath.BelowAFile("x.jsonl"));

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.StartWith($"nowpose: --record: {ImpossiblePath.BelowAFile("x.jsonl")}: cannot be written"));
        Assert.That(run.Output, Is.Empty);
    }

    [Test]
    [Platform("Linux")]
    public async Task Play_DeviceOfTheRecordingIsFull_HasFailed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = Simulate(gateway);

        var (run, _) = await PlayAsync(gateway, AfterCurrentFrames(1), "/dev/full");

        Assert.That(run.RecordingFault, Does.Contain("/dev/full"));
        Assert.That(run.HasFailed, Is.True);
    }

    static readonly string[][] InvalidRecordings =
    [
        ["--record night.jsonl.gz", HeadsetMessages.RecordingName("night.jsonl.gz")],
        ["--record night.CSV", HeadsetMessages.RecordingName("night.CSV")],
        ["--record-max-mb 5", HeadsetMessages.MaximumWithoutRecording],
    ];

    [TestCaseSource(nameof(InvalidRecordings))]
    public async Task Headset_InvalidRecording_IsRefused(string options, string message)
    {
        var run = await CliRun.OfAsync(["headset", "--sync-port", "1", "--ws-port", "1", .. options.Split(' ')]);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Complaints, Is.EqualTo(new[] { ConsoleMessages.Line(message) }));
    }

    [Test]
    public async Task Play_RecordingReachesItsMaximumSize_ReportsItDuringTheRun()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = Simulate(gateway);
        using var recording = new TemporaryFile("", ".jsonl");
        var lines = new List<string>();

        var (run, _) = await PlayAsync(
            gateway, _ => lines.Any(line => line.Contains(recording.Path)), recording.Path, say: lines.Add, megabytes: 0.02);

        Assert.That(run.RecordingFault, Is.EqualTo(RecordingMessages.MaxSize(recording.Path, "0.02")));
        Assert.That(lines, Has.One.EndsWith(": " + run.RecordingFault));
    }

    [Test]
    public async Task Play_RecordingReplacesALongerFile_LeavesNothingOfIt()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = Simulate(gateway);
        using var recording = new TemporaryFile(new string('x', 1_000_000), ".jsonl");

        var (run, _) = await PlayAsync(gateway, AfterCurrentFrames(1), recording.Path);

        Assert.That(run.RecordingFault, Is.Null);
        Assert.That(File.ReadAllText(recording.Path), Does.Not.Contain("xx"));
    }

    static Func<string, bool> AfterCurrentFrames(int count) => status => status.Contains("pose current", StringComparison.Ordinal) && --count <= 0;

    // Ends the run when the status of a frame shows that there is enough, instead of after a fixed time, because a busy machine synchronises later.
    static async Task<(HeadsetRun, HeadsetResult)> PlayAsync(
        GatewayServer gateway, Func<string, bool> isEnough, string recordingPath = null, string robot = null, Action<string> say = null,
        double megabytes = HeadsetSettings.DefaultRecordingMegabytes)
    {
        var settings = new HeadsetSettings
        {
            Connection = new ConnectionSettings("127.0.0.1", gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port),
            Predictor = Predictors.Default,
            Estimator = ClockEstimators.Default,
            Visualisation = new VisualisationLatency(TimeSpan.FromMilliseconds(40)),
            Seconds = Soon.Limit.TotalSeconds,
            FramesPerSecond = 60,
            RecordingPath = recordingPath,
            RecordingMegabytes = megabytes,
            Robot = robot == null ? null : RobotFiles.Load(robot),
        };
        using var enough = new CancellationTokenSource();
        void Look(double seconds, Func<string> status)
        {
            if (isEnough(status())) enough.Cancel();
        }

        var run = new HeadsetRun(settings, say ?? (_ => { }));
        var result = await Task.Factory.StartNew(
            () => run.Play(Look, enough.Token), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        Assert.That(enough.IsCancellationRequested, Is.True, result.Json());
        return (run, result);
    }

    [Test]
    public async Task Headset_GatewayWithTokenAndTls_Connects()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(
            Gateways.Options() with { Certificate = certificate, Tokens = Gateways.Tokens });
        using var cell = Simulate(gateway);
        using var token = new TemporaryFile(Gateways.ObserverToken + "\n", ".txt");

        using var run = new PeerProcess(
            "Nowpose.Cli.dll", ["headset", .. Ports(gateway), "--seconds", "600", "--pin", gateway.Pin.ToString(), "--token-file", token.Path]);

        await Soon.BecomesAsync(() => Regex.IsMatch(run.All, "clock (synchronised|coarse), .* [1-9][0-9]* samples"), () => run.All);
        await run.InterruptAsync();
        Assert.That(run.All, Does.Match("(synchronised|coarse), ±").And.Not.Contain(Gateways.ObserverToken));
    }

    [Test]
    public async Task Headset_PlantSendsNothing_Fails()
    {
        await using var gateway = await Gateways.StartAsync();

        var run = await RunAsync(gateway, "--seconds", "1", "--robot", "youbot");

        Assert.That(run.ExitStatus, Is.EqualTo(1));
        Assert.That(CapturedConsole.Lines(run.Errors), Has.One.StartsWith("nowpose: "));
    }

    [Test]
    public async Task Play_PlantSendsNothing_FailsWithTheReason()
    {
        await using var gateway = await Gateways.StartAsync();

        var (run, _) = await PlayAsync(gateway, status => status.Contains("clock synchronised", StringComparison.Ordinal), robot: "youbot");

        Assert.That(run.WhyFailed, Is.EqualTo(HeadsetMessages.NoJoints(null)).Or.EqualTo(HeadsetMessages.NoJoints("connecting")));
    }

    [Test]
    public async Task Play_JointNeverPublished_FailsAndNamesTheJoint()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = Simulate(gateway);
        // In this description, the name of one joint differs from the name that the cell publishes.
        using var urdf = new TemporaryFile(RobotFiles.LoadText("youbot").Replace("\"arm_joint_3\"", "\"arm_joint_x\""), ".urdf");

        var (run, played) = await PlayAsync(
            gateway, status => Regex.IsMatch(status, "clock synchronised, .* [1-9][0-9]* samples"), robot: urdf.Path);

        // On a busy machine, the newest samples of the other joints can be old at the end.
        Assert.That(run.WhyFailed, Does.Contain(HeadsetMessages.NeverCurrent("joint")).And.Contain("arm_joint_x: no value"));
        using var document = JsonDocument.Parse(played.Json());
        var result = document.RootElement;
        Assert.That(result.GetProperty("missing_joints").EnumerateArray().Select(joint => joint.GetString()), Does.Contain("arm_joint_x"));
        var never = result.GetProperty("joints").EnumerateArray().Single(joint => joint.GetProperty("name").GetString() == "arm_joint_x");
        Assert.That(never.GetProperty("state").GetString(), Is.EqualTo("missing"));
        Assert.That(result.GetProperty("pose").GetProperty("state").GetString(), Is.EqualTo("incomplete"));
        Assert.That(result.GetProperty("pose").GetProperty("current_after_s").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    [Test]
    public async Task Headset_EstimatorAndProfile_AreUsed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = Simulate(gateway);
        using var profile = Profile(63.5);

        var run = await RunAsync(gateway, "--seconds", "1", "--json", "--estimator", "ransac", "--profile", profile.Path);

        var result = JsonDocument.Parse(run.Output).RootElement;
        Assert.That(result.GetProperty("frames").GetInt32(), Is.EqualTo(60));
        Assert.That(result.GetProperty("latency_ms").GetProperty("visu").GetDouble(), Is.EqualTo(63.5));
    }

    [TestCase("headset", "--visu-ms")]
    [TestCase("demo", "--visu-error-ms")]
    public async Task Profile_WithAnotherLatencyOption_Fails(string verb, string option)
    {
        using var profile = Profile(63.5);

        var run = await CliRun.OfAsync(verb, "--profile", profile.Path, option, "10");

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo(ConsoleMessages.Line(OptionValueMessages.TwoLatencies(option))));
    }

    [TestCase("headset")]
    [TestCase("demo")]
    public async Task Estimator_UnknownName_Fails(string verb)
    {
        var run = await CliRun.OfAsync(verb, "--estimator", "kalman");

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.Contain("kalman").And.Contain("ransac"));
    }

    [Test]
    public void Estimator_HeadsetAndDemo_IsUsedByTheSession()
    {
        var connection = new ConnectionSettings("127.0.0.1", 1, 1);
        var headset = new HeadsetSettings { Connection = connection, Predictor = "linear", Estimator = "ransac" };
        var demo = new DemoSettings { Predictor = "linear", Estimator = "ransac" };

        Assert.That(headset.Session.ClockEstimator, Is.EqualTo("ransac"));
        Assert.That(DemoStage.SessionOf(demo, connection).ClockEstimator, Is.EqualTo("ransac"));
    }

    static TemporaryFile Profile(double visuMs)
    {
        var file = new TemporaryFile("", ".json");
        LatencyProfileFile.Save(file.Path, new LatencyProfile(visuMs, 1, "test device", 60, DateTime.UtcNow, CalibrationMethod.VisibleLight, 10));
        return file;
    }

    [Test]
    public async Task Headset_TokenFileMissing_Fails()
    {
        const string Missing = "/nowhere/token";

        var run = await CliRun.OfAsync("headset", "--token-file", Missing);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.StartWith($"nowpose: --token-file: {Missing}: cannot be read"));
    }

    static Task<CliRun> RunAsync(GatewayServer gateway, params string[] more) => CliRun.OfAsync(["headset", .. Ports(gateway), .. more]);

    static string[] Ports(GatewayServer gateway) =>
        ["--sync-port", Invariant($"{gateway.SyncEndPoint.Port}"), "--ws-port", Invariant($"{gateway.WebSocketEndPoint.Port}")];

    static SimulatedCell Simulate(GatewayServer gateway)
    {
        var robot = RobotFiles.Load("youbot", out var urdf);
        gateway.Hub.OpenSource().Describe(urdf);
        var timing = new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(20), TimeSpan.FromMilliseconds(40));
        var cell = new SimulatedCell(new CellMotion(new PickAndPlaceMotion(robot)), gateway.Clock, timing, 1);
        cell.PublishInto(gateway.Hub);
        return cell;
    }
}
