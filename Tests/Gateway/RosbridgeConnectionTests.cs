using System.Collections.Concurrent;
using System.Diagnostics;
using System.Net.WebSockets;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class RosbridgeConnectionTests
{
    readonly MessageHub _hub = new();

    static RosbridgeConnection Over(WebSocket socket, DropCounters drops = null)
    {
        ReaderProgress reader = null;
        Task Answer(ReadOnlyMemory<byte> ping)
        {
            reader.OnPong(ping.Span);
            return Task.CompletedTask;
        }

        reader = new ReaderProgress(Answer, TimeSpan.FromMinutes(1), TimeSpan.FromMinutes(1), TimeProvider.System);
        return new RosbridgeConnection(socket, null, reader, drops ?? new DropCounters(), CancellationToken.None);
    }

    Subscription Subscribe(string topic, DropCounters drops = null) => new(_hub, topic, default, 16, drops ?? new DropCounters());

    [Test]
    public async Task Start_EndedSubscriptions_AreReleased()
    {
        using var socket = WebSocket.CreateFromStream(new MemoryStream(), new WebSocketCreationOptions { IsServer = true });
        using var connection = Over(socket);
        var topics = 0;

        void StartAndEnd()
        {
            using var subscription = Subscribe($"/topic{topics++}");
            connection.Start(subscription);
        }

        for (var i = 0; i < 100; i++)
            StartAndEnd();
        await Soon.BecomesAsync(() => { StartAndEnd(); return connection.Topics < 10; }, "topics of ended subscriptions are removed");
    }

    [Test]
    public async Task Start_ManySubscriptionsWithAStoppedReader_UsesOnePumpAndCountsDrops()
    {
        const int Changes = 5000;
        using var socket = new StuckWebSocket();
        using var connection = Over(socket);
        using var source = _hub.OpenSource();
        var drops = new DropCounters();

        for (var i = 0; i < Changes; i++)
        {
            using var subscription = Subscribe(RosTopics.JointStates, drops);
            connection.Start(subscription);
            source.Publish(Gateways.State(i, "a"));
        }

        await Soon.BecomesAsync(() => socket.Sends == 1, "the first message is being sent");
        Assert.That(connection.Topics, Is.EqualTo(1));
        Assert.That(drops[DropReason.SlowReader], Is.EqualTo(Changes - 2), "all messages are dropped except the one being sent and the one waiting");
    }

    [Test]
    public async Task Start_PreviousSubscriptionStillSends_KeepsTheOrder()
    {
        using var socket = new StuckWebSocket();
        using var connection = Over(socket);
        using var source = _hub.OpenSource();
        var former = Subscribe(RosTopics.JointStates);
        connection.Start(former);
        // The time of arrival is in the future, so that no sample becomes too old.
        var receivedAt = Stopwatch.GetTimestamp() + (3600 * Stopwatch.Frequency);
        for (var i = 0; i < 5; i++) source.Publish(Gateways.State(i, "a"), receivedAt);
        await Soon.BecomesAsync(() => socket.Sends == 1, "the first message is being sent");
        former.Dispose();
        using var next = Subscribe(RosTopics.JointStates);
        connection.Start(next);
        for (var i = 5; i < 10; i++) source.Publish(Gateways.State(i, "a"), receivedAt);

        socket.GoOn();

        await Soon.BecomesAsync(() => socket.Sends == 10, "all are sent");
        var sent = socket.Sent.Select(text => RosbridgeReader.TryRead(text, out var message, out _) ? message.JointState.Positions[0] : -1);
        Assert.That(sent, Is.EqualTo(Enumerable.Range(0, 10)));
    }

    [TestCase(RosbridgeConnection.MinFragmentBytes)]
    [TestCase(100_000)]
    [TestCase(ProtocolLimits.DescriptionBytes - 100)]
    public async Task Start_LongMessage_IsSentInFragmentsThatEachNeedAPong(int bytes)
    {
        using var socket = new StuckWebSocket();
        socket.GoOn();
        using var connection = Over(socket);
        using var source = _hub.OpenSource();
        source.Describe(new string(' ', bytes), "");

        using var subscription = Subscribe(RosTopics.RobotDescription);
        connection.Start(subscription);

        await Soon.BecomesAsync(() => socket.Messages == 1, "the message is sent");
        var text = string.Concat(socket.Sent);
        Assert.That(RosbridgeReader.TryRead(text, out var message, out var reason), Is.True, reason.ToString());
        Assert.That(message.Data, Has.Length.EqualTo(bytes));
        var longest = Math.Max(RosbridgeConnection.MinFragmentBytes, text.Length / RosbridgeConnection.MaxFragments + 1);
        Assert.That(socket.Sent.Select(part => part.Length), Is.All.InRange(1, longest));
        Assert.That(socket.Sends, Is.EqualTo((text.Length + longest - 1) / longest).And.AtMost(RosbridgeConnection.MaxFragments));
    }

    [Test]
    public async Task Start_LongMessageWithoutPongs_SendsOneFragment()
    {
        using var socket = new StuckWebSocket();
        socket.GoOn();
        var pings = new BlockingCollection<byte[]>();
        using var reader = new ReaderProgress(
            payload =>
            {
                pings.Add(payload.ToArray());
                return Task.CompletedTask;
            },
            TimeSpan.FromMinutes(1), TimeSpan.FromMinutes(1), TimeProvider.System);
        using var connection = new RosbridgeConnection(socket, null, reader, new DropCounters(), CancellationToken.None);
        using var source = _hub.OpenSource();
        source.Describe(new string(' ', 100_000), "");
        using var subscription = Subscribe(RosTopics.RobotDescription);

        connection.Start(subscription);
        reader.OnPong(await Task.Run(pings.Take).Bounded());
        var second = await Task.Run(pings.Take).Bounded();

        Assert.That(socket.Sends, Is.EqualTo(1), "fragments before the pong of the ping after the first one");
        reader.OnPong(second);
        await Soon.BecomesAsync(() => socket.Sends > 1, "the pong lets the next fragments pass");
    }

    [Test]
    public void Reply_ClientReadsNoReplies_DropsAndCountsTheOldest()
    {
        using var socket = new StuckWebSocket();
        var drops = new DropCounters();
        using var connection = Over(socket, drops);

        for (var i = 0; i < RosbridgeConnection.WaitingReplies + 10; i++) connection.Reply(new byte[] { 1 });

        Assert.That(drops[DropReason.SlowReader], Is.EqualTo(10));
    }

    [Test]
    public async Task Client_SendsButNeverReads_IsDisconnected()
    {
        // The gateway sends no pings at the ping interval here, so the connection can end only because the client does not read.
        var options = Gateways.Options() with { PingInterval = TimeSpan.FromMinutes(5), PongTimeout = TimeSpan.FromMilliseconds(300) };
        await using var gateway = await Gateways.StartAsync(options);
        // The gateway sends 2 kB/s to a client that does not answer pings. With a small receive buffer, all buffers are soon full.
        using var client = await RawWebSocket.OpenAsync(gateway, receiveBytes: 1024);
        await client.SendFrameAsync(RawWebSocket.Text, Encoding.UTF8.GetBytes(RosbridgeWriter.Subscribe(RosTopics.JointStates)));
        using var source = gateway.Hub.OpenSource();
        var names = Enumerable.Range(0, 64).Select(i => "joint" + i).ToArray();

        await Soon.BecomesAsync(() =>
        {
            for (var i = 0; i < 20; i++) source.Publish(Gateways.State(i, names));
            TrySend(client);
            return gateway.WebSocketConnections[Closure.Silence] == 1 && gateway.WebSocketConnections.Open == 0;
        }, "closed, though it always has something to say");
    }

    static void TrySend(RawWebSocket client)
    {
        try
        {
            client.SendFrameAsync(RawWebSocket.Text, "{\"op\":\"status\",\"level\":\"none\",\"msg\":\"\"}"u8.ToArray()).GetAwaiter().GetResult();
        }
        catch (IOException)
        {
            // The gateway has closed the connection.
        }
    }
}
