using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests how the gateway forwards the poses that headsets display.</summary>
public class DisplayedTopicTests
{
    static readonly GatewayOptions WithTokens = Gateways.Options() with { Tokens = Gateways.Tokens };

    static string Shown(string headset, double position = 0.5, ControlTime? stamp = null) => RosbridgeWriter.Publish(
        RosTopics.Displayed, new JointStateMessage(stamp ?? Gateways.Start, ["a"], [position], frameId: headset), RosTimeForm.Sec);

    static string Said(string name) =>
        RosbridgeWriter.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(default, name, []), RosTimeForm.Sec);

    static Task<RawRosbridgeClient> ObserverAsync(GatewayServer gateway) => RawRosbridgeClient.ConnectAsync(
        gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.ObserverToken));

    [Test]
    public async Task DisplayedJoints_PublishedByAnObserver_AreSentOnlyOnTheirOwnTopic()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var page = await ObserverAsync(gateway);
        using var headset = await ObserverAsync(gateway);
        await page.SubscribeAsync(RosTopics.JointStates);
        await page.SubscribeAsync(RosTopics.Displayed);
        await headset.SendAsync(RosbridgeWriter.Advertise(RosTopics.Displayed, RosTopics.JointStateType));

        await headset.SendAsync(Shown("left door"));

        var shown = await page.ReceiveAsync();
        Assert.That(shown.Topic, Is.EqualTo(RosTopics.Displayed));
        Assert.That(shown.Displayed.FrameId, Is.EqualTo("left door"));
        Assert.That(shown.Displayed.Stamp, Is.EqualTo(Gateways.Start));
        Assert.That(shown.Displayed.Positions, Is.EqualTo(new[] { 0.5 }));
        await page.RoundTripAsync(); // no other message has arrived
    }

    [Test]
    public async Task DisplayedJoints_WithTheNameOfAnotherHeadset_AreRefused()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var headset = await ObserverAsync(gateway);
        await headset.SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, new DiagnosticsMessage(default, "h1", []), RosTimeForm.Sec));

        await headset.SendAsync(Shown("h2"));

        await headset.ExpectErrorAsync("the name h2 " + RequestMessages.OneName("h1"));
        Assert.That(gateway.Drops[DropReason.NotAllowed], Is.EqualTo(1));
    }

    [Test]
    public async Task Name_UsedByAnotherConnection_IsRefusedUntilThatConnectionEnds()
    {
        var time = new SteppedTime();
        await using var gateway = await Gateways.StartAsync(WithTokens with { Time = time });
        using var headset = await ObserverAsync(gateway);
        using var other = await ObserverAsync(gateway);
        await headset.SendAsync(Said("h1"));
        await headset.RoundTripAsync();

        await other.SendAsync(Said("h1"));
        await other.ExpectErrorAsync(CellMessageFaults.Of("the name h1", DropReason.JointTaken));
        await other.SendAsync(Shown("h1"));
        await other.ExpectErrorAsync(CellMessageFaults.Of("the name h1", DropReason.JointTaken));
        time.Advance(TimeSpan.FromSeconds(3));
        await other.SendAsync(Said("h1"));
        await other.RoundTripAsync();
        await headset.SendAsync(Shown("h1"));
        await headset.ExpectErrorAsync(CellMessageFaults.Of("the name h1", DropReason.JointTaken));
        await other.Socket.CloseAsync(System.Net.WebSockets.WebSocketCloseStatus.NormalClosure, "", default).Bounded();
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 1, "the other has disconnected");

        await headset.SendAsync(Shown("h1"));
        await headset.RoundTripAsync(); // no status has arrived
    }

    [Test]
    public async Task Diagnostics_WithThePlantsName_AreAllowedOnlyForSources()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var observer = await ObserverAsync(gateway);
        using var source = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.SourceToken));

        await observer.SendAsync(Said("plant/press"));
        await observer.ExpectErrorAsync("role");
        await observer.SendAsync(Shown("plant/press"));
        await observer.ExpectErrorAsync("role");

        await source.SendAsync(Said("plant/press"));
        await source.RoundTripAsync();
        await observer.SendAsync(Said("h1"));
        await observer.RoundTripAsync();
    }

    [Test]
    public async Task DisplayedJoints_PublishedBeforeTheSubscription_AreNotReceived()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var headset = await ObserverAsync(gateway);
        await headset.SendAsync(Shown("h1"));
        await headset.RoundTripAsync();
        using var page = await ObserverAsync(gateway);

        await page.SubscribeAsync(RosTopics.Displayed);

        await page.RoundTripAsync();
    }

    [Test]
    public async Task DisplayedJoints_TimeStampAnHourAhead_AreDropped()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var headset = await ObserverAsync(gateway);

        await headset.SendAsync(Shown("h1", stamp: Gateways.Start + TimeSpan.FromHours(1)));

        await headset.ExpectErrorAsync("StampInFuture");
    }

    [TestCase("\"frame_id\":\"\"", DropReason.MissingField)]
    [TestCase("\"frame_id\":7", DropReason.WrongType)]
    [TestCase("\"other\":1", DropReason.MissingField)]
    public void DisplayedJoints_WithoutAHeadsetName_AreRefused(string frame, object expected)
    {
        var text = Shown("h1").Replace("\"frame_id\":\"h1\"", frame);

        Assert.That(RosbridgeReader.TryRead(text, out _, out var reason), Is.False);
        Assert.That(reason, Is.EqualTo((DropReason)expected));
    }

    [Test]
    public void DisplayedJoints_HeadsetNameTooLong_AreRefused()
    {
        Assert.That(RosbridgeReader.TryRead(Shown(new string('x', ProtocolLimits.NameLength + 1)), out _, out var reason), Is.False);
        Assert.That(reason, Is.EqualTo(DropReason.NameTooLong));
    }

    [Test]
    public void JointState_AnyFrameId_IsAccepted()
    {
        var text = Gateways.StateText(1).Replace("\"frame_id\":\"\"", "\"frame_id\":7");

        Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, reason.ToString());
        Assert.That(message.JointState, Is.Not.Null);
        Assert.That(message.Displayed, Is.Null);
    }
}
