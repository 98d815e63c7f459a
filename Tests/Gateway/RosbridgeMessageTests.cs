using System.Net.WebSockets;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeMessageTests
{
    const string DiagnosticsAt = """{"op":"publish","topic":"/nowpose/diagnostics","msg":{"header":{"stamp":""";
    const string StampedAt = """{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":""";

    [Test]
    public async Task Description_OfNearly1MiB_IsForwarded()
    {
        await using var gateway = await Gateways.StartAsync();
        using var robot = await RawRosbridgeClient.ConnectAsync(gateway);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.RobotDescription);
        var urdf = new string('u', 1_000_000);

        await robot.SendAsync(RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(urdf)));

        Assert.That((await client.ReceiveAsync()).Data, Is.EqualTo(urdf));
    }

    [Test]
    public async Task GetTime_Called_ReturnsTheControlTime()
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

        await client.SendAsync(RosbridgeWriter.CallService("/rosapi/action_servers", "9"));

        var response = await client.ReceiveAsync();
        Assert.That((response.Op, response.Result, response.Id), Is.EqualTo((RosbridgeOp.ServiceResponse, false, (RequestId)"9")));
        Assert.That(gateway.Drops[DropReason.UnknownService], Is.EqualTo(1));
    }

    [TestCase("""{"op":"call_service","id":9,"service":"/rosapi/get_time"}""")]
    [TestCase("""{"op":"call_service","id":9,"service":"/rosapi/topics"}""")]
    [TestCase("""{"op":"call_service","id":9,"service":"/rosapi/nodes"}""")]
    [TestCase("""{"op":"call_service","id":9,"service":"/rosapi/action_servers"}""")]
    [TestCase("""{"op":"subscribe","id":9,"topic":"/joint_states","compression":"png"}""")]
    [TestCase("""{"op":"publish","id":9,"topic":"/joint_states","msg":{}}""")]
    [TestCase("""{"op":"dance","id":9}""")]
    public async Task Id_Integer_IsRepeatedAsANumber(string request)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync(request);

        Assert.That(await client.ReceiveTextAsync(), Does.Contain("\"id\":9,"));
    }

    [Test]
    public async Task Id_Integer_SelectsItsSubscription()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SendAsync("""{"op":"subscribe","id":9,"topic":"/joint_states"}""");

        await client.SendAsync("""{"op":"unsubscribe","id":"9","topic":"/joint_states"}""");
        Assert.That(await client.ReceiveTextAsync(), Does.Contain("warning"), "a string is another id than a number");
        await client.SendAsync("""{"op":"unsubscribe","id":9,"topic":"/joint_states"}""");

        await client.SendAsync(Gateways.StateText(1));
        await client.RoundTripAsync();
    }

    [TestCase("throttle_rate", "-1")]
    [TestCase("throttle_rate", "\"x\"")]
    [TestCase("queue_length", "50.5")]
    [TestCase("throttle_rate", "1099511627776")]
    [TestCase("type", "5")]
    public async Task Option_Unreadable_ReceivesAStatusWithOperationTopicAndId(string option, string value)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync($$"""{"op":"subscribe","{{option}}":{{value}},"topic":"/tf","id":"t7"}""");

        var text = await client.ReceiveTextAsync();
        Assert.That(text, Does.Contain("\"id\":\"t7\"").And.Contain("subscribe /tf dropped: "));
        Assert.That(gateway.Drops.Total, Is.EqualTo(1));
    }

    [TestCase("")]
    [TestCase("""{"hardware_id":"a","values":[]},{"hardware_id":"b","values":[]}""")]
    public async Task Diagnostics_NotOneStatus_AreDroppedWithThisReason(string status)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync($$$"""{"op":"publish","topic":"/nowpose/diagnostics","msg":{"status":[{{{status}}}]}}""");

        await client.ExpectErrorAsync("exactly one status");
    }

    [TestCase("""{"op":"dance","id":"1"}""", DropReason.UnknownOp, "Unknown operation: dance")]
    [TestCase("not json", DropReason.NotJson, "JSON")]
    [TestCase(StampedAt + """{"sec":5000,"nanosec":0}},"name":["a"],"position":[NaN]}}""", DropReason.NotFinite, "finite")]
    [TestCase(StampedAt + """{"sec":5000,"nanosec":0}},"name":["a","b"],"position":[1]}}""", DropReason.LengthMismatch, "length")]
    [TestCase(StampedAt + """{"sec":0,"nanosec":0}},"name":["a"],"position":[1]}}""", DropReason.StampZero, "zero")]
    [TestCase(StampedAt + """{"sec":5100,"nanosec":0}},"name":["a"],"position":[1]}}""", DropReason.StampInFuture, "(StampInFuture)")]
    [TestCase(DiagnosticsAt + """{"sec":5100,"nanosec":0}},"status":[{"hardware_id":"h1","values":[]}]}}""", DropReason.StampInFuture, "(StampInFuture)")]
    [TestCase("""{"op":"publish","topic":"/cmd_vel","msg":{}}""", DropReason.UnknownTopic, "/cmd_vel")]
    [TestCase("""{"op":"advertise","topic":"/joint_states","type":"std_msgs/String"}""", DropReason.WrongType, "type")]
    public async Task Message_Invalid_IsDroppedAndCountedAndTheConnectionStaysOpen(string text, object reason, string part)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);

        await client.SendAsync(text);

        await client.ExpectErrorAsync(part);
        Assert.That(gateway.Drops[(DropReason)reason], Is.EqualTo(1));
        Assert.That(gateway.Drops.Total, Is.EqualTo(1));
        await client.SendAsync(Gateways.StateText(1));
        Assert.That((await client.ReceiveAsync()).JointState, Is.Not.Null);
    }

    [Test]
    public async Task Message_Nested10000Deep_IsDroppedAndTheConnectionStaysOpen()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        await client.SendAsync("{\"op\":" + new string('[', 10_000) + new string(']', 10_000) + "}");

        await client.ExpectErrorAsync("nested");
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Message_Of2MiB_IsDroppedAndTheConnectionStaysOpen()
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

        await client.Socket.SendAsync(Encoding.UTF8.GetBytes(Gateways.StateText(1)), WebSocketMessageType.Binary, true, default).Bounded();

        await client.ExpectErrorAsync("text");
        await client.RoundTripAsync();
    }

    [TestCase(64, true)]
    [TestCase(65, false)]
    public async Task Message_InFragments_IsAcceptedUpTo64Fragments(int count, bool expected)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates);
        var text = Gateways.StateText(1);

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
    public async Task Message_NeverEnds_ClosesTheConnectionWithTheReason()
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
    public async Task Message_LongerThanTheDrainLimit_ClosesTheConnection()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { DrainBytes = 2_000_000 });
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        try
        {
            await client.SendAsync(new string(' ', 8_000_000));
        }
        catch (WebSocketException)
        {
            // The gateway has closed the connection during the send.
        }

        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.EndlessMessage] == 1, "counted");
    }
}
