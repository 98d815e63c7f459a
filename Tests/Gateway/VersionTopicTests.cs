using Nowpose.Gateway;
using Nowpose.Gateway.Plants;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

public class VersionTopicTests
{
    static CompensationSession NewSession() => new(
        new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), RobotFiles.Load("youbot"), new StopwatchHeadsetClock());

    [Test]
    public async Task Subscribe_VersionTopic_ReceivesTheVersionOfTheGateway()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Version, RosTopics.StringType));

        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo(NowposeVersion.Text));
    }

    [Test]
    public async Task Publish_VersionTopicByAClient_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.Publish(RosTopics.Version, new StringMessage("9.9.9")));

        Assert.That((await client.ReceiveAsync()).Op, Is.EqualTo(RosbridgeOp.Status));
        using var later = await RawRosbridgeClient.ConnectAsync(gateway);
        await later.SendAsync(RosbridgeWriter.Subscribe(RosTopics.Version, RosTopics.StringType));
        Assert.That((await later.ReceiveAsync()).Data, Is.EqualTo(NowposeVersion.Text));
    }

    [TestCase("9.9.9", true)]
    [TestCase(NowposeVersion.Text, false)]
    [TestCase("unreadable", false)]
    public void Session_ReceivesTheVersionOfTheGateway_ComparesItWithItsOwn(string version, bool isMismatch)
    {
        using var session = NewSession();

        session.Listener.VersionReceived(version);

        Assert.That(session.Statistics(default).VersionMismatch, isMismatch ? Does.Contain(version) : Is.Null);
    }

    [Test]
    public void Diagnostics_OfASession_ContainItsVersion()
    {
        using var session = NewSession();

        var values = session.Listener.Diagnostics().Values;

        Assert.That(values, Does.Contain(KeyValuePair.Create("version", NowposeVersion.Text)));
    }
}
