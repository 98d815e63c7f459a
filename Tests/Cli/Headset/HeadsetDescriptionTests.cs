using System.Text.Json;
using Nowpose.Cli.Headset;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli.Headset;

/// <summary>Tests that <c>headset</c> without a description of the robot is a failed run, whose result is printed.</summary>
[Parallelizable(ParallelScope.All), FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class HeadsetDescriptionTests
{
    [Test]
    public async Task Run_GatewayDescribesNoRobot_FailsAndPrintsTheResult()
    {
        await using var gateway = await Gateways.StartAsync();

        var (status, output, errors) = await RunAsync(Settings(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port));

        Assert.That(status, Is.EqualTo(1), errors);
        var result = JsonDocument.Parse(output).RootElement;
        Assert.That(result.GetProperty("robot").ValueKind, Is.EqualTo(JsonValueKind.Null));
        Assert.That(result.GetProperty("frames").GetInt32(), Is.Zero);
        Assert.That(result.GetProperty("missing_joints").GetArrayLength(), Is.Zero);
        Assert.That(result.GetProperty("pose").GetProperty("current_after_s").ValueKind, Is.EqualTo(JsonValueKind.Null));
    }

    [Test]
    public async Task Run_NoGateway_NamesTheConnectionFirst()
    {
        using var port = new ReservedPort();

        var (status, output, errors) = await RunAsync(Settings(port.Port, port.Port));

        Assert.That(status, Is.EqualTo(1), errors);
        Assert.That(JsonDocument.Parse(output).RootElement.GetProperty("samples").GetInt64(), Is.Zero);
        var cause = errors.IndexOf("refused", StringComparison.OrdinalIgnoreCase);
        Assert.That(cause, Is.InRange(0, errors.IndexOf("--robot", StringComparison.Ordinal)), errors);
    }

    [Test]
    public async Task Run_CancelledBeforeTheDescription_PrintsTheResultAndIsInterrupted()
    {
        using var port = new ReservedPort();

        var (status, output, _) = await RunAsync(Settings(port.Port, port.Port), new CancellationToken(canceled: true));

        Assert.That(status, Is.EqualTo(130));
        Assert.That(JsonDocument.Parse(output).RootElement.GetProperty("frames").GetInt32(), Is.Zero);
    }

    [TestCase(false)]
    [TestCase(true)]
    public async Task Run_RecordingWithoutARobot_LeavesNoNewFileAndKeepsAnEarlierOne(bool isEarlier)
    {
        using var port = new ReservedPort();
        using var folder = new TemporaryFolder();
        var path = Path.Combine(folder.Path, "session.jsonl");
        if (isEarlier) File.WriteAllText(path, "earlier");

        await RunAsync(Settings(port.Port, port.Port) with { RecordingPath = path }, new CancellationToken(canceled: true));

        Assert.That(Directory.GetFiles(folder.Path).Select(File.ReadAllText), Is.EqualTo(isEarlier ? new[] { "earlier" } : []));
    }

    [Test]
    public async Task Headset_RobotIsNotReadable_LeavesNoRecording()
    {
        using var folder = new TemporaryFolder();

        var run = await CliRun.OfAsync(
            "headset", "--record", Path.Combine(folder.Path, "session.jsonl"), "--robot", Path.Combine(folder.Path, "missing.urdf"));

        Assert.That(run.ExitStatus, Is.EqualTo(2), run.Errors);
        Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
    }

    static Task<(int Status, string Output, string Errors)> RunAsync(HeadsetSettings settings, CancellationToken cancel = default) =>
        CapturedConsole.OfAsync(() => Task.Factory.StartNew(
            () => HeadsetVerb.Run(settings, isJson: true, cancel), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default));

    static HeadsetSettings Settings(int syncPort, int webSocketPort) => new()
    {
        Connection = new ConnectionSettings("127.0.0.1", syncPort, webSocketPort),
        Predictor = Predictors.Default,
        Estimator = ClockEstimators.Default,
        Visualisation = new VisualisationLatency(TimeSpan.FromMilliseconds(40)),
        Seconds = 3,
        FramesPerSecond = 60,
        DescriptionTimeout = TimeSpan.FromSeconds(0.5),
    };
}
