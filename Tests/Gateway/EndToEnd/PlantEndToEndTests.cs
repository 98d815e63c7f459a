using Nowpose.Gateway.Plants;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.EndToEnd;

/// <summary>
/// Runs control system, adapter and gateway as processes, and the headset's runtime in this process. Compares the displayed pose with the
/// true pose of the robot, which is a function of the control system's own clock.
/// </summary>
public class PlantEndToEndTests
{
    static readonly TimeSpan Visualisation = TimeSpan.FromMilliseconds(40);

    [TestCase("opcua")]
    [TestCase("ads")]
    public async Task Headset_PlantWithItsOwnClock_ShowsTheTruePoseOfTheRobot(string kind)
    {
        using var folder = new TemporaryFolder();
        using var plant = await MovingPlant.StartAsync(kind);

        var score = await PlayAsync(plant, plant.Configure(folder.Path), RobotFiles.Load("youbot"));

        TestContext.Out.WriteLine($"{kind}: {score}");
        Require(score);
    }

    [Test]
    public async Task Headset_UniversalRobotOverRtde_ShowsTheTruePoseOfTheRobot()
    {
        using var folder = new TemporaryFolder();
        var robot = RobotFiles.Load("ur5e");
        using var plant = await RtdePlant.StartAsync(robot);

        var score = await PlayAsync(plant, plant.Configure(folder.Path), robot);

        TestContext.Out.WriteLine($"rtde: {score}");
        Require(score);
    }

    static async Task<PlantScore> PlayAsync(IPlantTruth plant, string configuration, RobotModel robot)
    {
        using var gateway = new PeerProcess("Nowpose.Gateway.dll", "serve", "--plant", configuration, "--sync-port", "0", "--ws-port", "0");
        await gateway.PrintsAsync("state serving");
        var clock = new StopwatchHeadsetClock();
        using var session = new CompensationSession(
            new SessionSettings(ConnectionTo(gateway), new VisualisationLatency(Visualisation)), robot, clock);
        session.Connect();
        await Soon.BecomesAsync(() => session.Tick(clock.Now).State == PoseState.Current, () => $"a current pose; the gateway wrote {gateway.All}");
        var steps = session.Statistics(clock.Now).ClockSteps;
        var score = new PlantScore(plant, robot, Visualisation);

        await Task.Factory.StartNew(
            () => score.Play(session, clock, TimeSpan.FromSeconds(3)), default, TaskCreationOptions.LongRunning, TaskScheduler.Default);
        // No clock step is counted. The gateway only corrects its estimate of the plant's clock.
        Assert.That(session.Statistics(clock.Now).ClockSteps, Is.EqualTo(steps), score.ToString());
        return score;
    }

    static void Require(PlantScore score)
    {
        Assert.That(score.CurrentShare, Is.GreaterThan(0), score.ToString());
        // Each exchange measures the bound, so the bound holds even on a busy machine.
        Assert.That(score.BoundHolds, Is.EqualTo(1), score.ToString());
        // The newest sample is at most two sampling intervals older than the newest stamp. A wrong clock, unit or order of joints gives a larger
        // difference. Tests in virtual time check by how much prediction reduces the error.
        Assert.That(score.SampleError, Is.LessThan(0.05), score.ToString());
    }

    static ConnectionSettings ConnectionTo(PeerProcess gateway) => new(
        "127.0.0.1", int.Parse(gateway.ValueOf("sync").Split(':')[1]), new Uri(gateway.ValueOf("websocket")).Port);
}
