using System.Buffers.Binary;
using System.Collections.Concurrent;
using System.Net;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tests that the gateway checks the size of a client's data before it stores, decodes or parses them.</summary>
[NonParallelizable] // measures the memory of the whole process
public class LimitTests
{
    const int Clients = 64;
    const int Mebibyte = 1024 * 1024;

    static readonly GatewayOptions WithTokens = Gateways.Options() with { Tokens = Gateways.Tokens };

    // Measuring the memory may take long, so the timeouts are long enough for clients that never answer a ping or never end their message.
    static readonly GatewayOptions Patient = WithTokens with
    {
        MaxPendingConnections = Clients,
        PongTimeout = TimeSpan.FromMinutes(2),
        MessageTimeout = TimeSpan.FromMinutes(2),
    };

    [Test]
    public async Task Messages_AboveTheRateLimit_AreDroppedUnparsedAndTheConnectionStaysOpen()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { SourceMessagesPerSecond = 5 });
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        for (var i = 0; i < 30; i++)
            await client.SendAsync("junk");

        await Soon.BecomesAsync(() => gateway.Drops.Total == 30, "all messages are dropped");
        Assert.That(gateway.Drops[DropReason.TooManyMessages], Is.GreaterThan(0));
        Assert.That(gateway.Drops[DropReason.NotJson], Is.GreaterThanOrEqualTo(5), "at least the messages of the first second are parsed");
        var (invalid, tooMany) = (DropMessages.Of(DropReason.NotJson), DropMessages.TooManyMessages(5));
        for (var i = 0; i < 30; i++) Assert.That((await client.ReceiveAsync()).Text, Does.Contain(invalid).Or.Contain(tooMany));
        await SendsAgainAsync(client);
    }

    [Test]
    public async Task Messages_TwoThousandFromASourceWithoutPause_AreAllAccepted()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        for (var i = 0; i < 2000; i++)
            await client.SendAsync(Gateways.StateText(i));

        await client.RoundTripAsync();
        Assert.That(gateway.Drops.Total, Is.Zero);
    }

    [Test]
    public async Task LongMessage_FromAnObserver_IsDroppedAsTooLarge()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var client = await RawRosbridgeClient.ConnectAsync(
            gateway, options => options.SetRequestHeader("Authorization", "Bearer " + Gateways.ObserverToken));

        await client.SendAsync(RosbridgeWriter.Publish(RosTopics.RobotDescription, new StringMessage(new string('u', 100_000))));

        await client.ExpectErrorAsync("longer");
        Assert.That(gateway.Drops[DropReason.TooLarge], Is.EqualTo(1));
    }

    [Test]
    public async Task LongMessage_NotADescription_IsDroppedUnparsed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawRosbridgeClient.ConnectAsync(gateway);

        // The message is deeply nested, so a parser would refuse it for another reason.
        await client.SendAsync(new string('[', 900_000));

        await client.ExpectErrorAsync("longer");
        Assert.That(gateway.Drops[DropReason.TooLarge], Is.EqualTo(1));
        Assert.That(gateway.Drops[DropReason.TooDeep], Is.Zero);
    }

    [Test]
    public async Task Memory_64ConnectionsWithIncompleteMessagesOf1MiB_StaysBounded()
    {
        await using var gateway = await Gateways.StartAsync(Patient);
        var clients = new List<RawWebSocket>();
        try
        {
            for (var i = 0; i < Clients; i++)
                clients.Add(await RawWebSocket.OpenAsync(gateway, $"Authorization: Bearer {Gateways.ObserverToken}\r\n"));
            var junk = UnfinishedMessage(Mebibyte);
            var before = GC.GetTotalMemory(true);

            await Task.WhenAll(clients.Select(client => client.SendAsync(junk)));
            // A reply to a ping after the frame shows that the gateway has read the whole frame.
            foreach (var client in clients) await client.SendFrameAsync(RawWebSocket.Ping);
            foreach (var client in clients) Assert.That((await client.ReceiveFrameAsync()).Opcode, Is.EqualTo(RawWebSocket.Pong));
            var kept = GC.GetTotalMemory(true) - before;

            Assert.That(gateway.WebSocketConnections.Open, Is.EqualTo(Clients));
            TestContext.Out.WriteLine($"kept of {Clients} MiB of junk: {kept / 1024} KiB");
            Assert.That(kept, Is.LessThan(Clients * 4L * ProtocolLimits.MessageBytes));
        }
        finally
        {
            foreach (var client in clients) client.Dispose();
        }
    }

    [Test]
    public async Task Log_ThousandsOfRefusals_ContainsFewLines()
    {
        var log = new ConcurrentQueue<string>();
        var gateway = await GatewayServer.StartAsync(
            Gateways.Options() with { Time = new SteppedTime() }, new Nowpose.Gateway.Clock.StopwatchControlClock(Gateways.Start), log.Enqueue);
        await using (gateway)
        {
            for (var i = 0; i < 200; i++)
            {
                using var client = await RawWebSocket.ConnectAsync(gateway);
                Assert.That(await client.RequestAsync("Origin: http://evil.example\r\n"), Does.StartWith("HTTP/1.1 403 "));
            }
        }

        Assert.That(log.Count(line => line.Contains("Origin")), Is.EqualTo(RateLimitedLog.LinesOfAKindAMinute + 1), "one line counts the other lines");
        Assert.That(log.Last(line => line.Contains("Origin")), Does.Contain("(100 more"));
        Assert.That(gateway.WebSocketConnections[Closure.Origin], Is.EqualTo(200));
    }

    [Test]
    public async Task PendingConnections_ManyFromOneAddress_DoNotBlockOtherAddresses()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens with { MaxPendingConnections = 3 });
        var silent = new List<RawSyncClient>();
        try
        {
            for (var i = 0; i < 10; i++) silent.Add(await RawSyncClient.ConnectAsync(gateway));
            await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.ConnectionLimit] == 7, "all connections beyond three are refused");
            Assert.That(gateway.SyncConnections.Open, Is.EqualTo(3));

            using var other = await RawSyncClient.ConnectAsync(gateway.SyncEndPoint, IPAddress.Parse("127.0.0.2"));
            await other.SendAsync(SyncToken.Write(Gateways.ObserverToken));

            Assert.That((await other.ReceiveAsync()).Value.IsAccepted, Is.True);
        }
        finally
        {
            foreach (var client in silent) client.Dispose();
        }
    }

    static async Task SendsAgainAsync(RawRosbridgeClient client)
    {
        // Repeats the call until the second in which there were too many messages has passed.
        while (true)
        {
            await client.SendAsync(RosbridgeWriter.CallService(RosTopics.GetTime, "again"));
            if ((await client.ReceiveAsync()).Id == "again") return;
        }
    }

    // Returns the first frame of a text message that has no other frame, so the message never ends.
    static byte[] UnfinishedMessage(long length)
    {
        var bytes = new byte[14 + length];
        bytes[0] = RawWebSocket.Text;
        bytes[1] = 0x80 | 127;
        BinaryPrimitives.WriteInt64BigEndian(bytes.AsSpan(2), length);
        bytes.AsSpan(14).Fill((byte)' ');
        return bytes;
    }
}
