using Nowpose.Gateway;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests which frames, message rates and numbers of connections make the sync port close a connection.</summary>
public class SyncServerLimitTests
{
    /// <summary>A limit long enough for responses on a busy machine and short enough for a test to wait for.</summary>
    static readonly TimeSpan LongToAnswer = TimeSpan.FromSeconds(1.5);

    [TestCase(0, "magic")]
    [TestCase(4, "version")]
    [TestCase(5, "kind")]
    public async Task Frame_Malformed_ClosesTheConnectionAndIsCounted(int at, string what)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);
        var bytes = new byte[SyncFrame.Size];
        SyncFrame.Request(1, 2).Write(bytes);
        bytes[at] ^= 0x40;

        await client.SendAsync(bytes);

        Assert.That(await client.ReceiveAsync(), Is.Null, what);
        Assert.That(gateway.SyncConnections[Closure.MalformedFrame], Is.EqualTo(1));
    }

    [TestCase(0, 0)]
    [TestCase(1, 1)]
    [TestCase(SyncFrame.Size - 1, 1)]
    public async Task Connection_EndedWithinAFrame_IsCountedAsMalformed(int bytes, int expected)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);
        var frame = new byte[SyncFrame.Size];
        SyncFrame.Request(1, 2).Write(frame);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);

        await client.SendAsync(frame[..bytes]);
        client.Dispose();

        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0, "closed");
        Assert.That(gateway.SyncConnections[Closure.MalformedFrame], Is.EqualTo(expected));
    }

    [TestCase(SyncFrameKind.Reply)]
    [TestCase(SyncFrameKind.TokenReply)]
    public async Task Frame_OfAKindThatOnlyServersSend_ClosesTheConnection(object kind)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(new SyncFrame((SyncFrameKind)kind, 0, 0, 0, 0, 0, 0, 0)), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.MalformedFrame], Is.EqualTo(1));
    }

    [Test]
    public async Task Requests_FasterThanAllowed_CloseTheConnection()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);

        // One write of more requests than the gateway allows in one moment is faster than any rate, on a busy machine, too.
        const int requests = 1000;
        var burst = new byte[requests * SyncFrame.Size];
        for (var i = 0; i < requests; i++) SyncFrame.Request(1, 2).Write(burst.AsSpan(i * SyncFrame.Size, SyncFrame.Size));
        await client.SendAsync(burst);

        var answered = 0;
        while (await client.ReceiveAsync() != null) answered++;
        Assert.That(answered, Is.LessThan(requests));
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.TooManyRequests] == 1, "counted");
    }

    [Test]
    public async Task Connection_Silent_IsClosed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { SyncSilence = LongToAnswer });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        var frame = new byte[SyncFrame.Size];
        SyncFrame.Request(1, 2).Write(frame);

        // On a busy machine, the gateway may close the connection before it reads the request.
        await TrySendAsync(client, frame);

        while (await client.ReceiveAsync() != null) { }
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.Silence] == 1, "counted");
    }

    [TestCase(true)]
    [TestCase(false)]
    public async Task Frame_SentByteByByteWithoutTokens_ClosesTheConnection(bool isFirst)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { TokenTimeout = LongToAnswer });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        if (!isFirst)
            Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        var frame = new byte[SyncFrame.Size];
        SyncFrame.Request(2, 2).Write(frame);

        // The frames are valid and the client is never silent, but each frame takes about five times as long as allowed.
        for (var i = 0; i < 10 * SyncFrame.Size && gateway.SyncConnections[Closure.Silence] == 0; i++)
        {
            await TrySendAsync(client, [frame[i % SyncFrame.Size]]);
            await Task.Delay(LongToAnswer / 10);
        }

        Assert.That(gateway.SyncConnections[Closure.Silence], Is.EqualTo(1));
    }

    static async Task TrySendAsync(RawSyncClient client, byte[] bytes)
    {
        try
        {
            await client.SendAsync(bytes);
        }
        catch (IOException)
        {
            // The gateway has closed the connection.
        }
    }

    [Test]
    public async Task Connections_TooMany_AreRefusedAndTheOthersAreServed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawSyncClient.ConnectAsync(gateway);
        Assert.That(await first.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);

        using var second = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await second.ReceiveAsync(), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.ConnectionLimit], Is.EqualTo(1));
        Assert.That(await first.ExchangeAsync(SyncFrame.Request(2, 2)), Is.Not.Null);
    }
}
