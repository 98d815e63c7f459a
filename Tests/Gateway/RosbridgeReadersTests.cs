using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeReadersTests
{
    [Test]
    public async Task Reader_Stops_DropsItsOldestMessagesWithoutDelayingOthers()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { PongTimeout = TimeSpan.FromMinutes(10) });
        using var slow = await RawRosbridgeClient.ConnectAsync(gateway, options => options.SetBuffer(1024, 1024));
        using var quick = await RawRosbridgeClient.ConnectAsync(gateway);
        await slow.SubscribeAsync(RosTopics.JointStates);
        await quick.SubscribeAsync(RosTopics.JointStates);
        using var source = gateway.Hub.OpenSource();
        var names = Enumerable.Range(0, 256).Select(i => "joint" + i).ToArray();

        // Publishes until all buffers between the gateway and the slow client are full and the queue has overflowed.
        var sent = 0;
        while (gateway.Drops[DropReason.SlowReader] < 100)
        {
            source.Publish(Gateways.State(++sent, names));
            Assert.That((await quick.ReceiveAsync()).JointState.Positions[0], Is.EqualTo(sent));
        }

        var received = new List<double>();
        do
            received.Add((await slow.ReceiveAsync()).JointState.Positions[0]);
        while (received[^1] < sent);

        Assert.That(received, Is.Ordered);
        Assert.That(received.Count, Is.EqualTo(sent - gateway.Drops[DropReason.SlowReader]));
        Assert.That(received[^1], Is.EqualTo(sent), "the newest sample is never dropped");
    }

    // The default buffers of the system can hold thousands of samples.
    [TestCase(null)]
    [TestCase(1024)]
    public async Task Reader_StopsAfterAPong_ReceivesAtMostAWindowAndAQueue(int? bufferBytes)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { PongTimeout = TimeSpan.FromMinutes(10) });
        using var client = await RawRosbridgeClient.ConnectAsync(
            gateway, options => { if (bufferBytes is { } bytes) options.SetBuffer(bytes, bytes); });
        await client.SubscribeAsync(RosTopics.JointStates);
        using var source = gateway.Hub.OpenSource();
        var read = 0;
        while (read < 20)
        {
            source.Publish(Gateways.State(read, "a"));
            Assert.That((await client.ReceiveAsync()).JointState.Positions[0], Is.EqualTo(read++));
        }

        const int Count = 2000;
        for (var i = 1; i <= Count; i++) source.Publish(Gateways.State(read + i, "a"));
        await Soon.BecomesAsync(() => gateway.Drops[DropReason.SlowReader] > Count / 2, "counted as dropped");
        var received = new List<double>();
        do
            received.Add((await client.ReceiveAsync()).JointState.Positions[0]);
        while (received[^1] < read + Count);

        var bytes = Encoding.UTF8.GetByteCount(Gateways.StateText(0));
        Assert.That(received, Is.Ordered);
        Assert.That(received.Count * bytes, Is.LessThan(6000 + (16 * bytes)), "messages in transit and in the queue");
        Assert.That(received.Count, Is.EqualTo(Count - gateway.Drops[DropReason.SlowReader]), "all other messages are counted as dropped");
    }

    [Test]
    public async Task Reader_DoesNotAnswerPings_IsClosed()
    {
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMilliseconds(100), PongTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway); // this client answers pings only while it receives

        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.Silence] == 1, "closed for silence");
    }

    [Test]
    public async Task Reader_StopsDuringALongMessage_IsClosedAfterThePongTimeout()
    {
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMilliseconds(100), PongTimeout = TimeSpan.FromMilliseconds(500) };
        await using var gateway = await Gateways.StartAsync(options);
        using var source = gateway.Hub.OpenSource();
        source.Describe(new string(' ', ProtocolLimits.DescriptionBytes / 2), "");
        using var client = await RawRosbridgeClient.ConnectAsync(gateway); // this client answers pings only while it receives
        await client.RoundTripAsync();

        await client.SendAsync(RosbridgeWriter.Subscribe(RosTopics.RobotDescription));

        await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.Silence] == 1, "closed for silence");
    }

    [Test]
    public async Task Source_SendsButDoesNotAnswerPings_IsClosed()
    {
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMilliseconds(100), PongTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawRosbridgeClient.ConnectAsync(gateway); // this client answers pings only while it receives

        var sent = 0;
        await Soon.BecomesAsync(
            () =>
            {
                client.SendAsync(Gateways.StateText(++sent)).ContinueWith(_ => { }, TaskScheduler.Default).Wait();
                return gateway.WebSocketConnections[Closure.Silence] == 1;
            },
            () => "closed for silence", 20);
    }

    [Test]
    public async Task Reader_AnswersPings_ReceivesFurtherPings()
    {
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMilliseconds(20), PongTimeout = TimeSpan.FromMinutes(10) };
        await using var gateway = await Gateways.StartAsync(options);
        using var raw = await RawWebSocket.OpenAsync(gateway);

        // The gateway sends a further ping only after the pong of the one before it.
        for (var i = 0; i < 5; i++)
        {
            var (opcode, payload) = await raw.ReceiveFrameAsync();
            Assert.That(opcode, Is.EqualTo(RawWebSocket.Ping));
            await raw.SendFrameAsync(RawWebSocket.Pong, payload);
        }

        await raw.SendFrameAsync(RawWebSocket.Text, Encoding.UTF8.GetBytes("""{"op":"dance"}"""));
        await Soon.BecomesAsync(() => gateway.Drops[DropReason.UnknownOp] == 1, "the request is processed");
        Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(1));
    }

    [Test]
    public async Task Subscription_Throttled_ReceivesAtMostOneMessagePerIntervalAndTheNewest()
    {
        const int Count = 20;
        var interval = TimeSpan.FromSeconds(0.5);
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.SubscribeAsync(RosTopics.JointStates, null, (int)interval.TotalMilliseconds);
        using var source = gateway.Hub.OpenSource();
        var since = System.Diagnostics.Stopwatch.GetTimestamp();

        for (var i = 1; i <= Count; i++)
            source.Publish(Gateways.State(i, "a"));
        var received = new List<double>();
        do
            received.Add((await client.ReceiveAsync()).JointState.Positions[0]);
        while (received[^1] < Count);

        Assert.That(received, Is.Ordered);
        Assert.That(
            (received.Count - 1) * interval, Is.LessThan(System.Diagnostics.Stopwatch.GetElapsedTime(since) + TimeSpan.FromMilliseconds(50)));
        Assert.That(gateway.Drops.Total, Is.Zero);
    }
}
