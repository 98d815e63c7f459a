using System.Collections.Concurrent;
using System.Net.Security;
using System.Net.Sockets;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Sync;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class SyncServerTests
{
    /// <summary>A limit long enough for answers on a busy machine and short enough for a test to wait for.</summary>
    static readonly TimeSpan LongToAnswer = TimeSpan.FromSeconds(1.5);

    [Test]
    public async Task Request_Answered_EchoesAndStampsInOrder()
    {
        var clock = new StopwatchControlClock(ControlTime.FromSeconds(-3), 50e-6);
        await using var gateway = await Gateways.StartAsync(clock: clock);
        using var client = await RawSyncClient.ConnectAsync(gateway);

        for (var i = 0u; i < 20; i++)
        {
            var before = clock.Now.Nanoseconds;
            var reply = (await client.ExchangeAsync(SyncFrame.Request(7 + i, -5 - i))).Value;
            var after = clock.Now.Nanoseconds;

            Assert.That(reply.Kind, Is.EqualTo(SyncFrameKind.Reply));
            Assert.That(reply.Sequence, Is.EqualTo(7 + i));
            Assert.That(reply.T1Ns, Is.EqualTo(-5 - i));
            Assert.That(new[] { before, reply.T2Ns, reply.T3Ns, after }, Is.Ordered);
            Assert.That(reply.IsServerSynchronised, Is.True);
            Assert.That(reply.ResolutionNs, Is.EqualTo(100));
        }
    }

    [Test]
    public async Task Request_ClockNotSynchronised_IsAnsweredWithStateBoundAndResolution()
    {
        var clock = new StopwatchControlClock(Gateways.Start)
        {
            IsSynchronised = false, ErrorBound = TimeSpan.FromMilliseconds(3), Resolution = TimeSpan.FromMilliseconds(1),
        };
        await using var gateway = await Gateways.StartAsync(clock: clock);
        using var client = await RawSyncClient.ConnectAsync(gateway);

        var reply = (await client.ExchangeAsync(SyncFrame.Request(1, 2))).Value;

        Assert.That(reply.IsServerSynchronised, Is.False);
        Assert.That(reply.ErrorBoundUs, Is.EqualTo(3000));
        Assert.That(reply.ResolutionNs, Is.EqualTo(1_000_000));
        Assert.That(reply.T2Ns % 1_000_000, Is.Zero);
    }

    [TestCase(0, "magic")]
    [TestCase(4, "version")]
    [TestCase(5, "kind")]
    public async Task Frame_Malformed_ClosesAndIsCounted(int at, string what)
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

    [TestCase(SyncFrameKind.Reply)]
    [TestCase(SyncFrameKind.TokenReply)]
    public async Task Frame_OfAServer_ClosesTheConnection(object kind)
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(new SyncFrame((SyncFrameKind)kind, 0, 0, 0, 0, 0, 0, 0)), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.MalformedFrame], Is.EqualTo(1));
    }

    [Test]
    public async Task Requests_FasterThanAllowed_Close()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);

        var answered = 0;
        while (answered <= 1000 && await client.ExchangeAsync(SyncFrame.Request(1, 2)) != null)
            answered++;

        Assert.That(answered, Is.GreaterThanOrEqualTo(100).And.LessThan(1000));
        Assert.That(gateway.SyncConnections[Closure.TooManyRequests], Is.EqualTo(1));
    }

    [Test]
    public async Task Connection_Silent_IsClosed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { SyncSilence = LongToAnswer });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);

        Assert.That(await client.ReceiveAsync(), Is.Null);
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

        // Valid frames, never silent, but each takes about five times as long as allowed.
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
    public async Task Connections_BeyondTheLimit_AreRefusedAndOthersServed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawSyncClient.ConnectAsync(gateway);
        Assert.That(await first.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);

        using var second = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await second.ReceiveAsync(), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.ConnectionLimit], Is.EqualTo(1));
        Assert.That(await first.ExchangeAsync(SyncFrame.Request(2, 2)), Is.Not.Null);
    }

    [Test]
    public async Task Token_Valid_IsServed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        await client.SendAsync(SyncToken.Write(Gateways.ObserverToken));

        Assert.That((await client.ReceiveAsync()).Value, Is.EqualTo(SyncFrame.TokenReply(true)));
        Assert.That((await client.ExchangeAsync(SyncFrame.Request(1, 2))).Value.Sequence, Is.EqualTo(1));
    }

    [Test]
    public async Task Token_Wrong_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        await client.SendAsync(SyncToken.Write("guess"));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.False);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
    }

    [Test]
    public async Task Token_Missing_RequestClosesTheConnection()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
    }

    [Test]
    public async Task Token_NotInTime_Closes()
    {
        var options = Gateways.Options() with { Tokens = Gateways.Tokens, TokenTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ReceiveAsync(), Is.Null);
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.Token] == 1, "counted");
    }

    [Test]
    public async Task Token_LongerThanAllowed_Closes()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        await client.SendAsync(SyncFrame.Token());

        await client.SendAsync([0x01, 0x02]);

        Assert.That(await client.ReceiveAsync(), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.MalformedFrame], Is.EqualTo(1));
    }

    [Test]
    public async Task Token_ServerWithoutTokens_AcceptsAny()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);

        await client.SendAsync(SyncToken.Write("left over"));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.True);
    }

    [Test]
    public async Task Tls_PinOfTheGateway_MatchesAndIsServed()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate, Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        var seen = default(CertificatePin);
        var secure = new SslStream(client.Stream, false, (_, given, _, _) => (seen = CertificatePin.Of(given)) != null);
        await secure.AuthenticateAsClientAsync("localhost").Bounded();
        client.Stream = secure;

        await client.SendAsync(SyncToken.Write(Gateways.SourceToken));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.True);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        Assert.That(seen, Is.EqualTo(gateway.Pin));
    }

    [Test]
    public async Task Tls_PlainClient_IsClosed()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.TlsHandshake], Is.EqualTo(1));
    }

    [Test]
    public async Task Tls_HandshakeMissing_IsCounted()
    {
        using var certificate = CertificateFiles.Generate();
        var options = Gateways.Options() with { Certificate = certificate, TokenTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ReceiveAsync(), Is.Null);
        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0, "closed");
        Assert.That(gateway.SyncConnections[Closure.TlsHandshake], Is.EqualTo(1));
    }

    [Test]
    public async Task Clock_Fails_EndsOnlyTheConnection()
    {
        await using var gateway = await Gateways.StartAsync(clock: new BrokenClock());
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.Failure], Is.EqualTo(1));
    }

    [Test]
    public async Task Thread_CannotStart_ReleasesItsPlace()
    {
        var log = new ConcurrentQueue<string>();
        var attempts = 0;
        void Start(SyncConnection connection)
        {
            if (++attempts == 1)
                throw new InsufficientMemoryException("no thread");
            connection.Start();
        }

        var clock = new StopwatchControlClock(Gateways.Start);
        var options = Gateways.Options() with { MaxConnections = 1 };
        using var access = new AccessWatch(options, log.Enqueue);
        using var server = new SyncServer(options, clock, access, new WrongTokens(TimeProvider.System), log.Enqueue, Start);
        using var first = await RawSyncClient.ConnectAsync(server.EndPoint);
        Assert.That(await first.ReceiveAsync(), Is.Null);
        using var second = await RawSyncClient.ConnectAsync(server.EndPoint);

        Assert.That(await second.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        Assert.That(server.Counters[Closure.Failure], Is.EqualTo(1));
        Assert.That(log.Single(), Does.Contain("Failure").And.Contain("no thread"));
    }

    [Test]
    public async Task Accept_Fails_IsRetried()
    {
        var failures = new Queue<Exception>(
            [new SocketException((int)SocketError.TooManyOpenSockets), new InsufficientMemoryException("no memory"), new IOException("disk")]);
        var log = new ConcurrentQueue<string>();
        using var access = new AccessWatch(Gateways.Options(), log.Enqueue);
        using var server = new SyncServer(
            Gateways.Options(), new StopwatchControlClock(Gateways.Start), access, new WrongTokens(TimeProvider.System), log.Enqueue,
            accept: listener => failures.TryDequeue(out var failure) ? throw failure : listener.AcceptSocketAsync());

        using var client = await RawSyncClient.ConnectAsync(server.EndPoint);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        Assert.That(log, Has.Count.EqualTo(3).And.All.Contain("could not be accepted"));
    }

    [Test]
    public async Task Gateway_StoppedWithOpenConnections_StartsAgainOnTheSamePorts()
    {
        var first = await Gateways.StartAsync();
        using var sync = await RawSyncClient.ConnectAsync(first);
        using var socket = await RawRosbridgeClient.ConnectAsync(first);
        await sync.ExchangeAsync(SyncFrame.Request(1, 2));
        await socket.RoundTripAsync();
        var options = new GatewayOptions { SyncPort = first.SyncEndPoint.Port, WebSocketPort = first.WebSocketEndPoint.Port };

        await first.DisposeAsync().AsTask().Bounded();
        Assert.That(await sync.ReceiveAsync(), Is.Null);
        await using var second = await Gateways.StartAsync(options);

        using var again = await RawSyncClient.ConnectAsync(second);
        Assert.That(await again.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        using var socketAgain = await RawRosbridgeClient.ConnectAsync(second);
        await socketAgain.RoundTripAsync();
    }

    [Test]
    public async Task Reply_ClockGoesBackByMicroseconds_IsStampedAfterTheRequest()
    {
        await using var gateway = await Gateways.StartAsync(clock: new BackwardClock());
        using var client = await RawSyncClient.ConnectAsync(gateway);

        var reply = (await client.ExchangeAsync(SyncFrame.Request(1, 2))).Value;

        Assert.That(reply.T3Ns, Is.EqualTo(reply.T2Ns));
    }

    sealed class BackwardClock : IControlClock
    {
        int _reads;

        public ControlTime Now => Gateways.Start - TimeSpan.FromMicroseconds(Interlocked.Increment(ref _reads));
    }

    sealed class BrokenClock : IControlClock
    {
        public ControlTime Now => throw new NotSupportedException("no clock");
    }
}
