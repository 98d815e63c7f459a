using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation.Work;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests that set-points of a simulated cell reach a session through a gateway over loopback.</summary>
public class GatewayPlanTests
{
    static readonly CellTiming Timing = new(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(20), TimeSpan.FromMilliseconds(40));

    [Test]
    public async Task Session_CellPublishesSetPoints_FollowsThem()
    {
        var control = new StopwatchControlClock(ControlTime.FromSeconds(1_700_000_000));
        var headset = new StopwatchHeadsetClock();
        await using var gateway = await Gateways.StartAsync(clock: control);
        var robot = RobotFiles.Load("youbot");
        using var cell = new SimulatedCell(new CellMotion(new PickAndPlaceMotion(robot)), control, Timing, 1, publishesPlan: true);
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1", gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port),
                new VisualisationLatency(TimeSpan.FromMilliseconds(40))), robot, headset);
        cell.PublishInto(gateway.Hub);
        session.Connect();

        await Soon.BecomesAsync(() => session.Tick(headset.Now).Kinds[0] == PredictionKind.Planned, "the plan is shown");

        Assert.That(session.Drops.Total, Is.EqualTo(0));
    }

    [Test]
    public async Task Publish_SetPoints_RequiresTheRoleSource()
    {
        var options = new Nowpose.Gateway.GatewayOptions { SyncPort = 0, WebSocketPort = 0, Tokens = Gateways.Tokens };
        await using var gateway = await Gateways.StartAsync(options);
        var received = 0;
        using var listening = gateway.Hub.Subscribe(RosTopics.JointTrajectory, _ => received++);
        var text = RosbridgeWriter.Publish(RosTopics.JointTrajectory, new JointTrajectoryMessage(
            Gateways.Start, ["a"], [new JointTrajectoryPoint(TimeSpan.Zero, [1])]), RosTimeForm.Sec);
        using var observer = await RawRosbridgeClient.ConnectAsync(gateway, With(Gateways.ObserverToken));
        using var source = await RawRosbridgeClient.ConnectAsync(gateway, With(Gateways.SourceToken));

        await observer.SendAsync(text);
        var refusal = await observer.ReceiveAsync();
        await source.SendAsync(text);

        Assert.That(refusal.Text, Does.Contain(nameof(DropReason.NotAllowed)));
        await Soon.BecomesAsync(() => received == 1, "the plan of the source");
    }

    static Action<System.Net.WebSockets.ClientWebSocketOptions> With(string token) =>
        options => options.SetRequestHeader("Authorization", "Bearer " + token);
}
