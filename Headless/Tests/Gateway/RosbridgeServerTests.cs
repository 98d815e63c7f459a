using System.Net;
using System.Net.WebSockets;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeServerTests
{
    static string State(double position, string name = "a", double stamp = 5000) => RosbridgeWriter.PublishJointState(
        RosTopics.JointStates, new JointStateMessage(ControlTime.FromSeconds(stamp), [name], [position]), RosTimeForm.Sec);

    [TestCase("sensor_msgs/JointState", "secs")]
    [TestCase("sensor_msgs/msg/JointState", "sec")]
    [TestCase(null, "sec")]
    public async Task Subscribe_TypeNamed_GetsItsSpellingOfTime(string type, string seconds)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, type);

        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(0.5, "a", "b"));

        var text = await client.ReceiveTextAsync();
        Assert.That(text, Does.Contain($"\"{seconds}\":5000"));
        Assert.That(RosbridgeReader.TryRead(text, out var message, out _), Is.True);
        Assert.That(message.JointState.Positions, Is.EqualTo(new[] { 0.5, 0.5 }));
        Assert.That(message.JointState.Stamp, Is.EqualTo(Gateways.Start));
    }

    [Test]
    public async Task RoslibStyleMessages_OfARealClient_AreServed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var robot = await RawRosbridgeClient.ConnectAsync(gateway);
        using var page = await RawRosbridgeClient.ConnectAsync(gateway);

        // As roslib.js writes them, field for field.
        await page.SendAsync("""{"op":"subscribe","id":"subscribe:/joint_states:1","type":"sensor_msgs/JointState","topic":"/joint_states","compression":"none","throttle_rate":0,"queue_length":0}""");
        await page.RoundTripAsync();
        await robot.SendAsync("""{"op":"advertise","id":"advertise:/joint_states:2","type":"sensor_msgs/JointState","topic":"/joint_states","latch":false,"queue_size":100}""");
        await robot.SendAsync("""{"op":"publish","id":"publish:/joint_states:3","topic":"/joint_states","msg":{"header":{"seq":3,"stamp":{"secs":5000,"nsecs":250000000},"frame_id":""},"name":["a"],"position":[1],"velocity":[],"effort":[NaN]},"latch":false}""");

        var message = await page.ReceiveAsync();
        Assert.That(message.JointState.Stamp, Is.EqualTo(ControlTime.FromSeconds(5000.25)));
        await page.SendAsync("""{"op":"unsubscribe","id":"subscribe:/joint_states:1","topic":"/joint_states"}""");
        await page.SendAsync("""{"op":"call_service","id":"call_service:/rosapi/get_time:4","service":"/rosapi/get_time","args":{}}""");
        Assert.That(await page.ReceiveTextAsync(), Does.Contain("\"secs\":").And.Contain("call_service:/rosapi/get_time:4"));
    }

    [Test]
    public async Task Unsubscribe_ThenPublish_GetsNothing()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);
        await client.SendAsync(RosbridgeWriter.Unsubscribe(RosTopics.JointStates));
        await client.RoundTripAsync();

        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(0.5, "a"));

        await client.RoundTripAsync();
    }

    [Test]
    public async Task Unsubscribe_OneOfTwoIds_GoesOnWithTheOther()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStates, null, "1"));
        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.JointStates, null, "2"));
        await client.SendAsync(RosbridgeWriter.Unsubscribe(RosTopics.JointStates, "1"));
        await client.RoundTripAsync();

        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(0.5, "a"));

        Assert.That((await client.ReceiveAsync()).JointState, Is.Not.Null);
        await client.RoundTripAsync(); // and not a second time
    }

    [Test]
    public async Task Description_PublishedBefore_IsSentOnSubscribe()
    {
        await using var gateway = await Gateways.StartAsync();
        using var source = gateway.Hub.OpenSource();
        source.TryDescribe("<robot name=\"r\"/>");
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.RobotDescription, "std_msgs/String"));

        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo("<robot name=\"r\"/>"));
    }

    [Test]
    public async Task Description_NearlyAMebibyte_Passes()
    {
        await using var gateway = await Gateways.StartAsync();
        using var robot = await RawRosbridgeClient.ConnectAsync(gateway);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.RobotDescription);
        var urdf = new string('u', 1_000_000);

        await robot.SendAsync(RosbridgeWriter.PublishString(RosTopics.RobotDescription, urdf));

        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo(urdf));
    }

    [Test]
    public async Task GetTime_Called_IsControlTime()
    {
        var clock = new StopwatchControlClock(ControlTime.FromSeconds(1e9), 1e-3);
        await using var gateway = await Gateways.StartAsync(clock: clock);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        var before = clock.Now;
        var time = (await client.RoundTripAsync()).Time.Value;

        Assert.That(time >= before && time <= clock.Now, Is.True);
    }

    [Test]
    public async Task Service_Unknown_FailsWithTheCallersId()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(RosbridgeWriter.CallService("/rosapi/topics", "9"));

        var response = await client.ReceiveAsync();
        Assert.That((response.Op, response.Result, response.Id), Is.EqualTo((RosbridgeOp.ServiceResponse, false, "9")));
        Assert.That(gateway.Drops[DropReason.UnknownService], Is.EqualTo(1));
    }

    [TestCase("""{"op":"dance","id":"1"}""", DropReason.UnknownOp, "Unknown operation: dance")]
    [TestCase("not json", DropReason.NotJson, "JSON")]
    [TestCase("""{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"sec":5000,"nanosec":0}},"name":["a"],"position":[NaN]}}""", DropReason.NotFinite, "finite")]
    [TestCase("""{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"sec":5000,"nanosec":0}},"name":["a","b"],"position":[1]}}""", DropReason.LengthMismatch, "length")]
    [TestCase("""{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"sec":0,"nanosec":0}},"name":["a"],"position":[1]}}""", DropReason.StampZero, "zero")]
    [TestCase("""{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"sec":5100,"nanosec":0}},"name":["a"],"position":[1]}}""", DropReason.StampInFuture, "future")]
    [TestCase("""{"op":"publish","topic":"/cmd_vel","msg":{}}""", DropReason.UnknownTopic, "/cmd_vel")]
    [TestCase("""{"op":"advertise","topic":"/joint_states","type":"std_msgs/String"}""", DropReason.WrongType, "type")]
    public async Task Message_AgainstARule_IsDroppedCountedToldAndTheConnectionGoesOn(string text, DropReason reason, string part)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);

        await client.SendAsync(text);

        await client.ExpectErrorAsync(part);
        Assert.That(gateway.Drops[reason], Is.EqualTo(1));
        Assert.That(gateway.Drops.Total, Is.EqualTo(1));
        await client.SendAsync(State(1));
        Assert.That((await client.ReceiveAsync()).JointState, Is.Not.Null);
    }

    [Test]
    public async Task Message_Nested10000Deep_IsDroppedAndTheConnectionGoesOn()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync("{\"op\":" + new string('[', 10_000) + new string(']', 10_000) + "}");

        await client.ExpectErrorAsync("nested");
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Message_OfTwoMebibytes_IsDroppedAndTheConnectionGoesOn()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(new string(' ', 2 * 1024 * 1024));

        await client.ExpectErrorAsync("longer");
        Assert.That(gateway.Drops[DropReason.TooLarge], Is.EqualTo(1));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Message_Binary_IsDropped()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.Socket.SendAsync(Encoding.UTF8.GetBytes(State(1)), WebSocketMessageType.Binary, true, default).Bounded();

        await client.ExpectErrorAsync("text");
        await client.RoundTripAsync();
    }

    [TestCase(64, true)]
    [TestCase(65, false)]
    public async Task Message_InFragments_UpTo64(int count, bool expected)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);
        var text = State(1);

        for (var i = 0; i < count; i++)
            await client.SendAsync(i < text.Length && i < count - 1 ? text[i].ToString() : text[i..], i == count - 1);

        if (expected)
            Assert.That((await client.ReceiveAsync()).JointState, Is.Not.Null);
        else
            await client.ExpectErrorAsync("fragments");
        Assert.That(gateway.Drops[DropReason.TooManyFragments], Is.EqualTo(expected ? 0 : 1));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Message_LateInEnding_IsDroppedAndTheConnectionGoesOn()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MessageTimeout = TimeSpan.FromMilliseconds(50) });
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync("{\"op\":", false);
        await Task.Delay(300);
        await client.SendAsync("\"status\",\"msg\":\"a\"}", true);

        await client.ExpectErrorAsync("in time");
        Assert.That(gateway.Drops[DropReason.TooSlow], Is.EqualTo(1));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Message_NeverEnding_ClosesWithTheReason()
    {
        var options = Gateways.Options() with { MessageTimeout = TimeSpan.FromMilliseconds(50), DrainTimeout = TimeSpan.FromMilliseconds(100) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync("{\"op\":", false);

        var result = await client.Socket.ReceiveAsync(new byte[100], default).Bounded();
        Assert.That(result.CloseStatus, Is.EqualTo(WebSocketCloseStatus.MessageTooBig));
        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.EndlessMessage] == 1, "counted");
    }

    [Test]
    public async Task Message_BeyondWhatIsDrained_Closes()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { DrainBytes = 2_000_000 });
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        try
        {
            await client.SendAsync(new string(' ', 8_000_000));
        }
        catch (WebSocketException)
        {
            // Closed while sending.
        }

        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.EndlessMessage] == 1, "counted");
    }

    [Test]
    public async Task Topics_MoreThan32_AreRefused()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        for (var i = 0; i < ProtocolLimits.TopicsPerClient; i++)
            await client.SubscribeAsync("/topic" + i);

        await client.SendAsync(RosbridgeWriter.Subscribe("/one_more"));
        await client.ExpectErrorAsync("32");

        await client.SendAsync(RosbridgeWriter.Advertise(RosTopics.JointStates, null));
        await client.ExpectErrorAsync("32");
        await client.SubscribeAsync("/topic0"); // not a further one
        await client.SendAsync(RosbridgeWriter.Unsubscribe("/topic0"));
        await client.SubscribeAsync("/one_more");
        Assert.That(gateway.Drops[DropReason.TooManyTopics], Is.EqualTo(2));
    }

    [Test]
    public async Task Source_SecondForAJoint_IsRefusedUntilTheFirstGoes()
    {
        await using var gateway = await Gateways.StartAsync();
        using var first = await RawRosbridgeClient.ConnectAsync(gateway);
        using var second = await RawRosbridgeClient.ConnectAsync(gateway);
        await first.SendAsync(State(1));
        await first.RoundTripAsync();

        await second.SendAsync(State(2));
        await second.ExpectErrorAsync("a belongs to another source");
        await second.SendAsync(State(2, "gripper"));
        await second.RoundTripAsync();

        await first.Socket.CloseAsync(WebSocketCloseStatus.NormalClosure, "", default).Bounded();
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 1, "first gone");
        await second.SendAsync(State(2));
        await second.RoundTripAsync();
        Assert.That(gateway.Drops[DropReason.JointTaken], Is.EqualTo(1));
    }

    [Test]
    public async Task Diagnostics_OfAHeadset_ReachWhoeverListens()
    {
        await using var gateway = await Gateways.StartAsync();
        using var headset = await RawRosbridgeClient.ConnectAsync(gateway);
        using var page = await RawRosbridgeClient.ConnectAsync(gateway);
        await page.SubscribeAsync(RosTopics.Diagnostics);
        var sent = new DiagnosticsMessage(default, "h1", [new("rtt_ms", "3.5")]);

        await headset.SendAsync(RosbridgeWriter.PublishDiagnostics(RosTopics.Diagnostics, sent, RosTimeForm.Sec));

        var received = (await page.ReceiveAsync()).Diagnostics;
        Assert.That(received.HardwareId, Is.EqualTo("h1"));
        Assert.That(received.Values, Is.EqualTo(sent.Values));
        await headset.SendAsync(RosbridgeWriter.PublishDiagnostics(RosTopics.Diagnostics, new DiagnosticsMessage(default, "h2", []), RosTimeForm.Sec));
        await headset.ExpectErrorAsync("role");
    }

    [Test]
    public async Task Reader_ThatStops_LosesTheOldestAndDelaysNobody()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { PongTimeout = TimeSpan.FromMinutes(1) });
        using var slow = await RawRosbridgeClient.ConnectAsync(gateway, options => options.SetBuffer(1024, 1024));
        using var quick = await RawRosbridgeClient.ConnectAsync(gateway);
        await slow.SubscribeAsync(RosTopics.JointStates);
        await quick.SubscribeAsync(RosTopics.JointStates);
        using var source = gateway.Hub.OpenSource();
        var names = Enumerable.Range(0, 256).Select(i => "joint" + i).ToArray();

        // Until what lies between the gateway and the slow client is full, then as much again as its queue holds.
        var sent = 0;
        while (gateway.Drops[DropReason.SlowReader] < 100)
        {
            source.TryPublish(Gateways.State(++sent, names));
            Assert.That((await quick.ReceiveAsync()).JointState.Positions[0], Is.EqualTo(sent));
        }

        var received = new List<double>();
        do
            received.Add((await slow.ReceiveAsync()).JointState.Positions[0]);
        while (received[^1] < sent);

        Assert.That(received, Is.Ordered);
        Assert.That(received.Count, Is.EqualTo(sent - gateway.Drops[DropReason.SlowReader]));
        Assert.That(received.TakeLast(16), Is.EqualTo(Enumerable.Range(sent - 15, 16).Select(i => (double)i)));
    }

    [Test]
    public async Task Reader_ThatAnswersNoPing_IsClosed()
    {
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMilliseconds(100), PongTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway); // which answers only while it receives

        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.Silence] == 1, "closed for silence");
    }

    [Test]
    public async Task Reader_ThatAnswersPings_StaysConnected()
    {
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMilliseconds(100), PongTimeout = TimeSpan.FromMilliseconds(500) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);

        var receiving = client.ReceiveAsync();
        await Task.Delay(3000);
        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(1, "a"));

        Assert.That((await receiving).JointState, Is.Not.Null);
    }

    [Test]
    public async Task Subscription_Throttled_GetsTheNewestAtItsRate()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, null, 300);
        using var source = gateway.Hub.OpenSource();
        source.TryPublish(Gateways.State(1, "a"));
        var first = (await client.ReceiveAsync()).JointState.Positions[0];
        var since = System.Diagnostics.Stopwatch.GetTimestamp();

        for (var i = 2; i <= 20; i++)
            source.TryPublish(Gateways.State(i, "a"));
        var second = (await client.ReceiveAsync()).JointState.Positions[0];

        Assert.That((first, second), Is.EqualTo((1.0, 20.0)));
        Assert.That(System.Diagnostics.Stopwatch.GetElapsedTime(since).TotalMilliseconds, Is.GreaterThan(200));
        Assert.That(gateway.Drops.Total, Is.Zero);
    }

    [Test]
    public async Task Connections_BeyondTheLimit_AreAnswered503()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawRosbridgeClient.ConnectAsync(gateway);

        Assert.That(await RefusalAsync(gateway, null), Is.EqualTo(HttpStatusCode.ServiceUnavailable));
        await first.RoundTripAsync();
    }

    [Test]
    public async Task Compression_AskedFor_IsNotAgreed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway, options => options.DangerousDeflateOptions = new WebSocketDeflateOptions());

        Assert.That(client.Socket.HttpResponseHeaders.ContainsKey("Sec-WebSocket-Extensions"), Is.False);
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Gateway_Stopped_SaysGoodbye()
    {
        var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.RoundTripAsync();
        var receiving = client.Socket.ReceiveAsync(new byte[100], default);

        await gateway.DisposeAsync();

        Assert.That((await receiving.Bounded()).CloseStatus, Is.EqualTo(WebSocketCloseStatus.EndpointUnavailable));
    }

    internal static async Task<HttpStatusCode> RefusalAsync(GatewayServer gateway, Action<ClientWebSocketOptions> set)
    {
        using var socket = new ClientWebSocket();
        set?.Invoke(socket.Options);
        socket.Options.CollectHttpResponseDetails = true;
        if (gateway.Pin != null)
            socket.Options.RemoteCertificateValidationCallback = (_, certificate, _, _) => gateway.Pin.Matches(certificate);
        Assert.ThrowsAsync<WebSocketException>(() => socket.ConnectAsync(gateway.WebSocketUri(), default).Bounded());
        await Task.CompletedTask;
        return socket.HttpStatusCode;
    }
}
