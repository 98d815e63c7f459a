using System.Globalization;
using System.Net.WebSockets;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeTopicTests
{
    [TestCase("sensor_msgs/JointState", "secs")]
    [TestCase("sensor_msgs/msg/JointState", "sec")]
    [TestCase(null, "sec")]
    public async Task Subscribe_WithType_ReceivesTheTimeFormatOfTheType(string type, string seconds)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, type);

        using var source = gateway.Hub.OpenSource();
        source.Publish(Gateways.State(0.5, "a", "b"));

        var text = await client.ReceiveTextAsync();
        Assert.That(text, Does.Contain($"\"{seconds}\":5000"));
        Assert.That(RosbridgeReader.TryRead(text, out var message, out _), Is.True);
        Assert.That(message.JointState.Positions, Is.EqualTo(new[] { 0.5, 0.5 }));
        Assert.That(message.JointState.Stamp, Is.EqualTo(Gateways.Start));
    }

    [Test]
    public async Task Messages_FromRoslib_AreServed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var robot = await RawRosbridgeClient.ConnectAsync(gateway);
        using var page = await RawRosbridgeClient.ConnectAsync(gateway);

        // These messages have exactly the fields that roslib.js sends.
        await page.SendAsync("""{"op":"subscribe","id":"subscribe:/joint_states:1","type":"sensor_msgs/JointState","""
            + """ "topic":"/joint_states","compression":"none","throttle_rate":0,"queue_length":0}""");
        await page.RoundTripAsync();
        await robot.SendAsync("""{"op":"advertise","id":"advertise:/joint_states:2","type":"sensor_msgs/JointState","""
            + """ "topic":"/joint_states","latch":false,"queue_size":100}""");
        await robot.SendAsync("""{"op":"publish","id":"publish:/joint_states:3","topic":"/joint_states","msg":{"header":"""
            + """{"seq":3,"stamp":{"secs":5000,"nsecs":250000000},"frame_id":""},"name":["a"],"position":[1],"velocity":[],"""
            + """ "effort":[NaN]},"latch":false}""");

        var message = await page.ReceiveAsync();
        Assert.That(message.JointState.Stamp, Is.EqualTo(ControlTime.FromSeconds(5000.25)));
        await page.SendAsync("""{"op":"unsubscribe","id":"subscribe:/joint_states:1","topic":"/joint_states"}""");
        await page.SendAsync("""{"op":"call_service","id":"call_service:/rosapi/get_time:4","service":"/rosapi/get_time","args":{}}""");
        Assert.That(await page.ReceiveTextAsync(), Does.Contain("\"secs\":").And.Contain("call_service:/rosapi/get_time:4"));
    }

    [Test]
    public async Task Unsubscribe_BeforePublication_ReceivesNothing()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);
        await client.SendAsync("""{"op":"unsubscribe","topic":"/joint_states"}""");
        await client.RoundTripAsync();

        using var source = gateway.Hub.OpenSource();
        source.Publish(Gateways.State(0.5, "a"));

        await client.RoundTripAsync();
    }

    [Test]
    public async Task Unsubscribe_OneOfTwoIds_KeepsTheOtherSubscription()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync("""{"op":"subscribe","topic":"/joint_states","id":"1"}""");
        await client.SendAsync("""{"op":"subscribe","topic":"/joint_states","id":"2"}""");
        await client.SendAsync("""{"op":"unsubscribe","topic":"/joint_states","id":"1"}""");
        await client.RoundTripAsync();

        using var source = gateway.Hub.OpenSource();
        source.Publish(Gateways.State(0.5, "a"));

        Assert.That((await client.ReceiveAsync()).JointState, Is.Not.Null);
        await client.RoundTripAsync(); // the sample has not been sent a second time
    }

    [Test]
    public async Task Description_PublishedEarlier_IsSentOnSubscribe()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.Describe("<robot name=\"r\"/>");
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.RobotDescription, "std_msgs/String"));

        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo("<robot name=\"r\"/>"));
    }

    [Test]
    public async Task Topics_MoreThan64_AreRefused()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        for (var i = 0; i < ProtocolLimits.TopicsPerClient; i++)
            await SubscribeToUnknownAsync(client, "/topic" + i);

        await client.SendAsync(RosbridgeWriter.Subscribe("/one_more"));
        await client.ExpectErrorAsync("64");

        await client.SendAsync(RosbridgeWriter.Advertise(RosTopics.JointStates, null));
        await client.ExpectErrorAsync("64");
        await SubscribeToUnknownAsync(client, "/topic0"); // the gateway creates no further topic
        await client.SendAsync("""{"op":"unsubscribe","topic":"/topic0"}""");
        await SubscribeToUnknownAsync(client, "/one_more");
        Assert.That(gateway.Drops[DropReason.TooManyTopics], Is.EqualTo(2));
    }

    [Test]
    public async Task Subscribe_MoreThan64IdsOfATopic_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        for (var i = 0; i < ProtocolLimits.SubscriptionsPerTopic; i++) await client.SendAsync(Subscribe(i.ToString(CultureInfo.InvariantCulture)));
        await client.RoundTripAsync();

        await client.SendAsync(Subscribe("one more"));
        await client.ExpectErrorAsync(DropMessages.TooManySubscriptions);
        Assert.That(gateway.Drops[DropReason.TooManyTopics], Is.EqualTo(1));

        await client.SendAsync(Subscribe("0"));
        await client.SendAsync("""{"op":"unsubscribe","topic":"/joint_states","id":"0"}""");
        await client.SendAsync(Subscribe("one more"));
        await client.RoundTripAsync();
        Assert.That(gateway.Drops.Total, Is.EqualTo(1));
    }

    [TestCase(0, 0)]
    [TestCase(1, 1)]
    public async Task Subscribe_LongId_IsRefusedAboveTheMaximumLength(int more, int dropped)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(Subscribe(new string('i', ProtocolLimits.KeyLength + more)));

        if (dropped > 0) await client.ExpectErrorAsync(DropMessages.IdTooLong);
        await client.RoundTripAsync();
        Assert.That(gateway.Drops[DropReason.NameTooLong], Is.EqualTo(dropped));
    }

    static string Subscribe(string id) => $$"""{"op":"subscribe","topic":"{{RosTopics.JointStates}}","id":"{{id}}"}""";

    [Test]
    public async Task Subscribe_TopicNeverPublished_ReceivesAWarning()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await SubscribeToUnknownAsync(client, "/foo");

        Assert.That(gateway.Drops.Total, Is.Zero);
    }

    [TestCase(RosTopics.JointStates)]
    [TestCase(RosTopics.JointTrajectory)]
    [TestCase(RosTopics.RobotDescription)]
    [TestCase(RosTopics.Diagnostics)]
    [TestCase(RosTopics.Displayed)]
    [TestCase(RosTopics.JointStatus)]
    [TestCase(RosTopics.Tf)]
    [TestCase(RosTopics.TfStatic)]
    [TestCase(RosTopics.Signals)]
    [TestCase("/arm1/joint_states")]
    public async Task Subscribe_TopicWithoutASource_ReceivesNoWarning(string topic)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.Subscribe(topic));
        await client.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime, "after"));

        RosbridgeMessage message;
        do
        {
            message = await client.ReceiveAsync();
            Assert.That(message.Op, Is.Not.EqualTo(RosbridgeOp.Status), message.Text);
        }
        while (message.Id != "after");
    }

    [TestCase("sensor_msgs/msg/JointState", "sensor_msgs/JointState", RosTimeForm.Sec)]
    [TestCase("sensor_msgs/JointState", null, RosTimeForm.Secs)]
    [TestCase(null, "sensor_msgs/msg/JointState", null)]
    public async Task Subscribe_AgainWithAnotherTimeFormat_ReceivesAWarning(string first, string second, object format)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        string Subscribe(string id, string type) => System.Text.Json.JsonSerializer.Serialize(new { op = "subscribe", id, topic = RosTopics.JointStates, type });
        await client.SendAsync(Subscribe("a", first));
        await client.RoundTripAsync();

        await client.SendAsync(Subscribe("b", second));

        if (format != null)
        {
            var warning = await client.ReceiveAsync();
            Assert.That((warning.Op, warning.Level, warning.Id), Is.EqualTo((RosbridgeOp.Status, "warning", (RequestId)"b")));
            Assert.That(warning.Text, Does.Contain(RequestMessages.OtherTimeForm((RosTimeForm)format)));
        }

        await client.RoundTripAsync();
    }

    static async Task SubscribeToUnknownAsync(RawRosbridgeClient client, string topic)
    {
        await client.SendAsync(RosbridgeWriter.Subscribe(topic));
        var warning = await client.ReceiveAsync();
        Assert.That((warning.Op, warning.Level), Is.EqualTo((RosbridgeOp.Status, "warning")));
        Assert.That(warning.Text, Does.StartWith($"subscribe {topic} {RequestMessages.NotPublished("")}").And.Contain(RosTopics.JointStates));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task SecondSource_ForSomeJoints_ReceivesThatTheseJointsAreLeftOut()
    {
        await using var gateway = await Gateways.StartAsync();
        using var first = await RawRosbridgeClient.ConnectAsync(gateway);
        using var second = await RawRosbridgeClient.ConnectAsync(gateway);
        await first.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, Gateways.State(1, "a", "b")));
        await first.RoundTripAsync();

        await second.SendAsync(RosbridgeWriter.Publish(RosTopics.JointStates, Gateways.State(2, "a", "b", "c")));

        await second.ExpectErrorAsync(
            $"{StatusReplies.JointsLeftOut}: {CellMessageFaults.Of("a", DropReason.JointTaken)}, rosbridge 127.0.0.1 (1 more) ({DropReason.JointTaken})");
    }

    [Test]
    public async Task SecondSource_ForAJoint_IsRefusedUntilTheFirstEnds()
    {
        await using var gateway = await Gateways.StartAsync();
        using var first = await RawRosbridgeClient.ConnectAsync(gateway);
        using var second = await RawRosbridgeClient.ConnectAsync(gateway);
        await first.SendAsync(Gateways.StateText(1));
        await first.RoundTripAsync();

        await second.SendAsync(Gateways.StateText(2));
        await second.ExpectErrorAsync(CellMessageFaults.Of("a", DropReason.JointTaken));
        await second.SendAsync(Gateways.StateText(2, "gripper"));
        await second.RoundTripAsync();

        await first.Socket.CloseAsync(WebSocketCloseStatus.NormalClosure, "", default).Bounded();
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 1, "the first has disconnected");
        await second.SendAsync(Gateways.StateText(2));
        await second.RoundTripAsync();
        Assert.That(gateway.Drops[DropReason.JointTaken], Is.EqualTo(1));
    }

    // C1 may be the time since the start of a robot's controller, while the machine of the adapter has Unix time.
    [Test]
    public async Task Diagnostics_FromAnAdapterWithAnotherClock_ReachAllSubscribers()
    {
        await using var gateway = await Gateways.StartAsync();
        using var page = await RawRosbridgeClient.ConnectAsync(gateway);
        using var adapter = await RawRosbridgeClient.ConnectAsync(gateway);
        await page.SubscribeAsync(RosTopics.Diagnostics);
        var sent = new DiagnosticsMessage(gateway.Clock.Now + TimeSpan.FromDays(20_000), "plant/plc", [new("state", "connected")]);

        await adapter.SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, sent, RosTimeForm.Sec));

        Assert.That((await page.ReceiveAsync()).Diagnostics.Stamp, Is.EqualTo(sent.Stamp));
    }

    [Test]
    public async Task Diagnostics_FromAHeadset_ReachAllSubscribers()
    {
        await using var gateway = await Gateways.StartAsync();
        using var headset = await RawRosbridgeClient.ConnectAsync(gateway);
        using var page = await RawRosbridgeClient.ConnectAsync(gateway);
        await page.SubscribeAsync(RosTopics.Diagnostics);
        var sent = new DiagnosticsMessage(default, "h1", [new("rtt_ms", "3.5")], 2, "h", "no pose");

        await headset.SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, sent, RosTimeForm.Sec));

        var received = (await page.ReceiveAsync()).Diagnostics;
        Assert.That(received.HardwareId, Is.EqualTo("h1"));
        Assert.That(received.Values, Is.EqualTo(sent.Values));
        Assert.That((received.Level, received.Name, received.Message), Is.EqualTo((2, "h", "no pose")));
        var another = new DiagnosticsMessage(default, "h2", []);
        await headset.SendAsync(RosbridgeWriter.Publish(RosTopics.Diagnostics, another, RosTimeForm.Sec));
        await headset.ExpectErrorAsync("the name h2 " + RequestMessages.OneName("h1"));
    }
}
