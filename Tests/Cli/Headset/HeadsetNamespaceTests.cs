using System.Text.Json;
using Nowpose.Cli.Headset;
using Nowpose.Cli.Messages;
using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Messages;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Simulation.Work;
using Nowpose.Sync;
using NUnit.Framework;
using static System.FormattableString;

namespace Nowpose.Headless.Tests.Cli.Headset;

/// <summary>Tests <c>headset</c> with a gateway that serves two robots, arm1 and arm2.</summary>
[Parallelizable(ParallelScope.All), FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class HeadsetNamespaceTests
{
    [Test]
    public async Task Headset_NamespaceOfOneRobot_ReceivesThatRobot()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = SimulateTwo(gateway);

        var run = await CliRun.OfAsync(
            "headset", "--sync-port", Invariant($"{gateway.SyncEndPoint.Port}"), "--ws-port", Invariant($"{gateway.WebSocketEndPoint.Port}"),
            "--namespace", "arm2", "--seconds", "4", "--json");

        var result = JsonDocument.Parse(run.Output).RootElement;
        Assert.That(result.GetProperty("robot").GetString(), Is.EqualTo(RobotFiles.Load("youbot").Name));
        Assert.That(result.GetProperty("samples").GetInt64(), Is.GreaterThan(0), run.Errors);
        var joints = result.GetProperty("joints").EnumerateArray().ToList();
        Assert.That(joints.Select(joint => joint.GetProperty("state").GetString()), Has.None.EqualTo("missing"));
    }

    [TestCase("")]
    [TestCase("arm3")]
    public async Task Play_NoRobotInTheNamespace_NamesTheOptionAndTheNamespaces(string robotNamespace)
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = SimulateTwo(gateway);
        var settings = Settings(gateway) with { RobotNamespace = robotNamespace, DescriptionTimeout = TimeSpan.FromSeconds(3) };

        var run = new HeadsetRun(settings, _ => { });

        await PlayAsync(run);

        Assert.That(run.WhyFailed, Is.EqualTo(OtherNamespaces(robotNamespace)));
    }

    [Test]
    public async Task Play_RobotGivenWithoutItsNamespace_NamesTheOptionAndTheNamespaces()
    {
        await using var gateway = await Gateways.StartAsync();
        using var cell = SimulateTwo(gateway);
        var run = new HeadsetRun(Settings(gateway) with { Robot = RobotFiles.Load("youbot") }, _ => { });

        await PlayAsync(run);

        Assert.That(run.WhyFailed, Is.EqualTo(OtherNamespaces("")));
    }

    [Test]
    public async Task Play_NoRobotAtAll_ReportsTheMissingDescription()
    {
        await using var gateway = await Gateways.StartAsync();
        var settings = Settings(gateway) with { RobotNamespace = "arm1", DescriptionTimeout = TimeSpan.FromSeconds(0.5) };

        var run = new HeadsetRun(settings, _ => { });

        await PlayAsync(run);

        Assert.That(run.WhyFailed, Does.Contain("arm1").And.Contain("--robot"));
    }

    [TestCase("1arm")]
    [TestCase("arm/1")]
    public async Task Namespace_Invalid_Fails(string name)
    {
        var run = await CliRun.OfAsync("headset", "--namespace", name);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Does.StartWith($"nowpose: --namespace: is '{name}'; allowed:"));
    }

    static string OtherNamespaces(string name) => HeadsetMessages.OtherNamespaces(RobotMessages.OtherNamespaces(name, ["arm1", "arm2"]));

    static Task<HeadsetResult> PlayAsync(HeadsetRun run) => Task.Factory.StartNew(
        () => run.Play((_, _) => { }, CancellationToken.None), CancellationToken.None, TaskCreationOptions.LongRunning, TaskScheduler.Default);

    static HeadsetSettings Settings(GatewayServer gateway) => new()
    {
        Connection = new ConnectionSettings("127.0.0.1", gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port),
        Predictor = Predictors.Default,
        Estimator = ClockEstimators.Default,
        Visualisation = new VisualisationLatency(TimeSpan.FromMilliseconds(40)),
        Seconds = 3,
        FramesPerSecond = 60,
    };

    static SimulatedCell SimulateTwo(GatewayServer gateway)
    {
        var robot = RobotFiles.Load("youbot", out var urdf);
        var work = new CellWork(robot, new PickAndPlaceMotion(robot), 2);
        var source = gateway.Hub.OpenSource();
        foreach (var each in work.Robots) source.Describe(urdf, each.Namespace);
        var timing = new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(20), TimeSpan.FromMilliseconds(40));
        var cell = new SimulatedCell(new CellMotion(work), gateway.Clock, timing, 1);
        cell.PublishInto(gateway.Hub);
        return cell;
    }
}
