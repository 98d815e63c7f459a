using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Gateway;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests the robot description that a gateway sends to a session over loopback.</summary>
public class GatewayDescriptionTests
{
    readonly StopwatchHeadsetClock _clock = new();

    CompensationSession Connect(GatewayServer gateway, string robot)
    {
        var connection = new ConnectionSettings("127.0.0.1", gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port);
        var session = new CompensationSession(
            new SessionSettings(connection, new VisualisationLatency(TimeSpan.FromMilliseconds(40))), RobotFiles.Load(robot), _clock);
        session.Connect();
        return session;
    }

    [TestCase("youbot", RobotDescriptionMatch.Same)]
    [TestCase("ur5", RobotDescriptionMatch.Different)]
    public async Task Session_GatewayDescribesItsRobot_ComparesItWithTheDisplayedRobot(string displayed, object expected)
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Describe(RobotFiles.LoadText("youbot"));
        using var session = Connect(gateway, displayed);

        await Soon.BecomesAsync(() => session.RobotDescription != null, "a description");

        Assert.That(session.RobotDescription, Is.EqualTo(RobotFiles.LoadText("youbot")));
        Assert.That(session.Statistics(_clock.Now).RobotDescriptionMatch, Is.EqualTo((RobotDescriptionMatch)expected));
        Assert.That(session.DescribedRobot.Name, Is.EqualTo(RobotFiles.Load("youbot").Name));
    }

    [Test]
    public async Task Session_GatewayHasNoDescription_StaysUnknown()
    {
        await using var gateway = await Gateways.StartAsync();
        using var session = Connect(gateway, "youbot");
        using var source = gateway.Hub.OpenSource();

        await Soon.BecomesAsync(() => Tick(session, source).Samples > 0, "samples");

        Assert.That(session.RobotDescriptionMatch, Is.EqualTo(RobotDescriptionMatch.Unknown));
        Assert.That(session.RobotDescription, Is.Null);
    }

    [Test]
    public async Task Session_InvalidDescription_CountsItAndReceivesSamples()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Describe("<robot name='half'>");
        using var session = Connect(gateway, "youbot");

        await Soon.BecomesAsync(() => session.Drops[DropReason.NotUrdf] == 1, "the description is counted as dropped");
        await Soon.BecomesAsync(() => Tick(session, source).Samples > 0, "samples");

        Assert.That(session.RobotDescriptionMatch, Is.EqualTo(RobotDescriptionMatch.Unknown));
        source.Describe(RobotFiles.LoadText("youbot"));
        await Soon.BecomesAsync(() => session.RobotDescriptionMatch == RobotDescriptionMatch.Same, "the next description is used");
    }

    SessionStatistics Tick(CompensationSession session, Nowpose.Gateway.Hub.HubSource source)
    {
        source.Publish(Gateways.State(0.5, "arm_joint_1"));
        session.Tick(_clock.Now);
        return session.Statistics(_clock.Now);
    }
}
