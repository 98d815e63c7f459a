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

    [Test]
    public async Task Reader_StopsAfterAPong_ReceivesAtMostAWindowAndAQueue()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { PongTimeout = TimeSpan.FromMinutes(10) });
        // The connection has the default buffers of the system, which can hold thousands of samples.
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
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

    // Ages and read rates are measured in samples of the source and not in real time, because a busy machine slows both down.
    [Test]
    public async Task Reader_At4KilobytesPerSecond_ReceivesNoSampleOlderThanASecond()
    {
        const int Bytes = 80, Samples = 100;
        var interval = TimeSpan.FromMilliseconds(20);
        await using var gateway = await Gateways.StartAsync();
        using var small = await PacedReader.OpenAsync(gateway, receiveBytes: 1024);
        using var standard = await PacedReader.OpenAsync(gateway);
        PacedReader[] readers = [small, standard];
        using var source = gateway.Hub.OpenSource();
        using var timer = new PeriodicTimer(interval);
        var now = Gateways.Start;

        for (var i = 0; i < Samples; i++)
        {
            await timer.WaitForNextTickAsync();
            now += interval;
            source.Publish(SevenJoints(now));
            foreach (var reader in readers) await reader.ReadAsync(Bytes, now);
        }

        var ages = readers.Select(reader => reader.MaxAge.TotalSeconds).ToArray();
        Assert.That(ages, Is.Not.Empty.And.All.InRange(interval.TotalSeconds, 1.0), "age in s with a small and a standard receive buffer");
        Assert.That(readers.Select(reader => reader.Pongs), Has.All.GreaterThan(1));
        await Soon.BecomesAsync(() => Array.TrueForAll(readers, reader => ReadRest(reader, now)), "the newest is read");
        Assert.That(readers.Sum(reader => reader.Samples), Is.EqualTo((readers.Length * Samples) - gateway.Drops[DropReason.SlowReader]));
        Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(readers.Length));
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
    public async Task Reader_AnswersPings_StaysConnected()
    {
        var options = Gateways.Options() with
        {
            PingInterval = TimeSpan.FromMilliseconds(100),
            PongTimeout = TimeSpan.FromSeconds(3),
        };
        await using var gateway = await Gateways.StartAsync(options);
        using var raw = await RawWebSocket.OpenAsync(gateway);

        // Reads for longer than a connection without pongs stays open.
        for (var i = 0; i < 35; i++)
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
    public async Task Subscription_Throttled_ReceivesTheNewestMessageInEachInterval()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        // The throttle interval is much longer than the time in which all samples are published.
        await client.SubscribeAsync(RosTopics.JointStates, null, 2000);
        using var source = gateway.Hub.OpenSource();
        var since = System.Diagnostics.Stopwatch.GetTimestamp();
        source.Publish(Gateways.State(1, "a"));
        var first = (await client.ReceiveAsync()).JointState.Positions[0];

        for (var i = 2; i <= 20; i++)
            source.Publish(Gateways.State(i, "a"));
        var second = (await client.ReceiveAsync()).JointState.Positions[0];

        Assert.That((first, second), Is.EqualTo((1.0, 20.0)));
        Assert.That(System.Diagnostics.Stopwatch.GetElapsedTime(since).TotalSeconds, Is.GreaterThan(1.9));
        Assert.That(gateway.Drops.Total, Is.Zero);
    }

    static bool ReadRest(PacedReader reader, ControlTime newest)
    {
        reader.ReadAsync(int.MaxValue, newest).GetAwaiter().GetResult();
        return reader.Newest == newest;
    }

    // Returns a joint state that has about 450 bytes as JSON, like the state of a moving arm.
    static JointStateMessage SevenJoints(ControlTime stamp)
    {
        var seconds = (stamp - Gateways.Start).TotalSeconds;
        var joints = Enumerable.Range(1, 7).ToArray();
        return new JointStateMessage(
            stamp, [.. joints.Select(i => $"joint_{i}")], [.. joints.Select(i => Math.Sin(i + seconds))], [.. joints.Select(i => Math.Cos(i + seconds))]);
    }
}
