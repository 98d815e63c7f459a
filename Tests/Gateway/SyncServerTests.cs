using System.Collections.Concurrent;
using System.Net.Sockets;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Sync;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the replies of the sync port and its recovery from failures.</summary>
public class SyncServerTests
{
    [Test]
    public async Task Request_Valid_ReplyEchoesItAndHasTimeStampsInOrder()
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
    public async Task Request_ClockNotSynchronised_ReplyContainsStateBoundAndResolution()
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

    [Test]
    public async Task Reply_ClockGoesBackByMicroseconds_IsNotStampedBeforeTheRequest()
    {
        await using var gateway = await Gateways.StartAsync(clock: new BackwardClock());
        using var client = await RawSyncClient.ConnectAsync(gateway);

        var reply = (await client.ExchangeAsync(SyncFrame.Request(1, 2))).Value;

        Assert.That(reply.T3Ns, Is.EqualTo(reply.T2Ns));
    }

    [Test]
    public async Task Request_ClockThrows_EndsTheConnectionAndIsCounted()
    {
        await using var gateway = await Gateways.StartAsync(clock: new BrokenClock());
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.Failure], Is.EqualTo(1));
    }

    [Test]
    public async Task Connection_ThreadCannotStart_IsNoLongerCounted()
    {
        var log = new ConcurrentQueue<string>();
        var attempts = 0;
        void Start(ServedSyncConnection connection)
        {
            if (++attempts == 1)
                throw new InsufficientMemoryException("no thread");
            connection.Start();
        }

        var clock = new StopwatchControlClock(Gateways.Start);
        var options = Gateways.Options() with { MaxConnections = 1 };
        using var access = new AccessWatch(options, log.Enqueue);
        using var server = new SyncServer(options, clock, access, new WrongTokens(TimeProvider.System), (line, _) => log.Enqueue(line), Start);
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
            Gateways.Options(), new StopwatchControlClock(Gateways.Start), access, new WrongTokens(TimeProvider.System), (line, _) => log.Enqueue(line),
            accept: listener => failures.TryDequeue(out var failure) ? throw failure : listener.AcceptSocketAsync());

        using var client = await RawSyncClient.ConnectAsync(server.EndPoint);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        var expected = SyncServerMessages.NotAccepted(MessagePattern.Any, MessagePattern.Any);
        Assert.That(log, Has.Count.EqualTo(3).And.All.Match(MessagePattern.Of(expected)));
        Assert.That(server.Counters[Closure.DescriptorLimit], Is.EqualTo(1), "only the first failure");
    }

    [Test]
    public async Task Gateway_StoppedWithOpenConnections_CanRestartOnTheSamePorts()
    {
        using ReservedPort syncPort = new(), webSocketPort = new();
        var options = new GatewayOptions { SyncPort = syncPort.Port, WebSocketPort = webSocketPort.Port };
        var first = await Gateways.StartAsync(options);
        using var sync = await RawSyncClient.ConnectAsync(first);
        using var socket = await RawRosbridgeClient.ConnectAsync(first);
        await sync.ExchangeAsync(SyncFrame.Request(1, 2));
        await socket.RoundTripAsync();

        await first.DisposeAsync().AsTask().Bounded();
        Assert.That(await sync.ReceiveAsync(), Is.Null);
        await using var second = await Gateways.StartAsync(options);

        using var again = await RawSyncClient.ConnectAsync(second);
        Assert.That(await again.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        using var socketAgain = await RawRosbridgeClient.ConnectAsync(second);
        await socketAgain.RoundTripAsync();
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
