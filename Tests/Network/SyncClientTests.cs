using System.Collections.Concurrent;
using System.Diagnostics;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Sync;
using Nowpose.Sync.Ransac;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public class SyncClientTests
{
    static readonly TimeSpan Quick = TimeSpan.FromMilliseconds(5);

    SyncFaultCounters _faults;

    [SetUp]
    public void ResetFaults() => _faults = new SyncFaultCounters();

    (SyncClient Client, ClockSynchroniser Clock) Connect(int port, CertificatePin pin = null)
    {
        var clock = new ClockSynchroniser(new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default);
        return (new SyncClient(new ConnectionSettings("127.0.0.1", port, pin: pin), new StopwatchHeadsetClock(), clock, _faults, new ExchangePace(Quick, Quick, new Random(1))), clock);
    }

    static SyncFrame Reply(SyncFrame request, long t2Ns = 1000, long t3Ns = 2000, uint? sequence = null, long? t1Ns = null) =>
        new(SyncFrameKind.Reply, 0, sequence ?? request.Sequence, 0, t1Ns ?? request.T1Ns, t2Ns, t3Ns, 0);

    [Test]
    public async Task Exchange_CorrectServer_SynchronisesTheClock()
    {
        var offset = TimeSpan.FromHours(3);
        var headset = new StopwatchHeadsetClock();
        using var server = new FakeSyncServer(request =>
        {
            var now = (headset.Now - offset).Nanoseconds;
            return FakeSyncServer.Bytes(Reply(request, now, now));
        });
        var (client, clock) = Connect(server.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => clock.ModelAt(headset.Now).State == ClockState.Synchronised, "synchronised");

            var model = clock.ModelAt(headset.Now);
            Assert.That(client.Status.State, Is.EqualTo(LinkState.Connected));
            Assert.That((model.OffsetAt(headset.Now).HeadsetMinusControl - offset).Duration(), Is.LessThanOrEqualTo(model.ErrorBound + TimeSpan.FromMilliseconds(1)));
            Assert.That(_faults.Total, Is.EqualTo(0));
        }
    }

    [TestCase(SyncExchangeFault.WrongSequence)]
    [TestCase(SyncExchangeFault.WrongEcho)]
    [TestCase(SyncExchangeFault.ControlTimeReversed)]
    [TestCase(SyncExchangeFault.NegativeRoundTrip)]
    public async Task Exchange_TenInvalidRepliesInARow_CountsThemAndReconnects(object fault)
    {
        using var server = new FakeSyncServer(request => FakeSyncServer.Bytes((SyncExchangeFault)fault switch
        {
            SyncExchangeFault.WrongSequence => Reply(request, sequence: request.Sequence + 1),
            SyncExchangeFault.WrongEcho => Reply(request, t1Ns: request.T1Ns + 100),
            SyncExchangeFault.ControlTimeReversed => Reply(request, t2Ns: 5000, t3Ns: 4999),
            _ => Reply(request, t2Ns: 0, t3Ns: 3_600_000_000_000),
        }));
        var (client, clock) = Connect(server.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => server.Connections >= 2, "a second connection");

            Assert.That(_faults[(SyncExchangeFault)fault], Is.GreaterThanOrEqualTo(ProtocolLimits.SyncDropsInARow));
            Assert.That(Enum.GetValues<SyncExchangeFault>().Where(each => _faults[each] > 0), Is.EqualTo(new[] { (SyncExchangeFault)fault }));
            Assert.That(clock.ModelAt(default).State, Is.EqualTo(ClockState.Unsynchronised));
        }
    }

    [TestCase(new byte[] { 0x48, 0x54, 0x54, 0x50 }, "WrongMagic")]
    [TestCase(new byte[] { 0x53, 0x59, 0x4E, 0x43, 9 }, "WrongVersion")]
    [TestCase(new byte[] { 0x53, 0x59, 0x4E, 0x43, 1, 7 }, "WrongKind")]
    public async Task Exchange_ReplyIsNotASyncFrame_ClosesWithTheReason(byte[] start, string named)
    {
        using var server = new FakeSyncServer(_ =>
        {
            var bytes = new byte[SyncFrame.Size];
            start.CopyTo(bytes, 0);
            return bytes;
        });
        var (client, _) = Connect(server.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => client.Status.State == LinkState.Waiting && client.Status.Detail.Contains(named), named);
            Assert.That(_faults[SyncExchangeFault.NotAFrame], Is.GreaterThanOrEqualTo(1));
        }
    }

    [Test]
    public async Task Exchange_ServerEndsWithinAFrame_CountsTheFrame()
    {
        using var server = new FakeTcpServer(stream =>
        {
            stream.ReadExactly(new byte[SyncFrame.Size]);
            stream.Write(new byte[SyncFrame.Size - 1]);
        });
        var (client, _) = Connect(server.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => server.Connections >= 2, "a second connection");

            Assert.That(_faults[SyncExchangeFault.NotAFrame], Is.GreaterThanOrEqualTo(1));
        }
    }

    [Test]
    public async Task Exchange_OneInvalidReply_DoesNotReconnect()
    {
        var headset = new StopwatchHeadsetClock();
        var invalid = new ConcurrentDictionary<int, int>();
        FakeSyncServer server = null;
        using var ending = server = new FakeSyncServer(request =>
        {
            var now = headset.Now.Nanoseconds;
            var isInvalid = request.Sequence % 5 == 0;
            if (isInvalid) invalid.AddOrUpdate(server.Connections, 1, (_, count) => count + 1);
            return FakeSyncServer.Bytes(Reply(request, now, isInvalid ? now - 1000 : now));
        });
        var (client, clock) = Connect(server.Port);
        using (client)
        {
            // On a busy machine, a reply may be late, which ends the connection.
            await Soon.BecomesAsync(() => invalid.Values.Any(count => count >= 5), "five invalid replies on one connection");

            Assert.That(_faults.Total, Is.GreaterThanOrEqualTo(4));
            Assert.That(clock.ModelAt(headset.Now).IsKnown, Is.True);
        }
    }

    [Test]
    public async Task Exchange_ServerClosesAfterTheFirstReply_IncreasesTheRetryDelay()
    {
        // Times at which the client sends, because the server may accept a connection late on a busy machine.
        var requests = new ConcurrentQueue<long>();
        var request = new byte[SyncFrame.Size];
        using var server = new FakeTcpServer(stream =>
        {
            stream.ReadExactly(request);
            SyncFrame.TryRead(request, out var frame, out _);
            requests.Enqueue(frame.T1Ns);
            stream.Write(FakeSyncServer.Bytes(Reply(frame)));
        });
        var (client, clock) = Connect(server.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => requests.Count >= 5, "five connections");

            Assert.That(clock.Exchanges, Is.GreaterThan(0));
            var times = requests.ToArray();
            Assert.That(times[4] - times[3], Is.GreaterThan(1_000_000_000), "the delay of 1.5 s");
        }
    }

    [Test]
    public async Task Exchange_ServerDoesNotReply_TimesOutWithTheReasonAndReconnects()
    {
        using var server = new FakeSyncServer(_ => []);
        var since = Stopwatch.GetTimestamp();
        var (client, _) = Connect(server.Port);
        using (client)
        {
            var reason = "";
            await Soon.BecomesAsync(
                () =>
                {
                    if (client.Status.State == LinkState.Waiting) reason = client.Status.Detail;
                    return server.Connections >= 2;
                },
                "a second connection");

            Assert.That(reason, Is.EqualTo("clock sync: " + ConnectionMessages.NoResponse(ProtocolLimits.SyncReplyTimeout.TotalSeconds)));

            Assert.That(Stopwatch.GetElapsedTime(since), Is.GreaterThan(ProtocolLimits.SyncReplyTimeout - TimeSpan.FromMilliseconds(100)));
        }
    }

    [Test]
    public async Task Exchange_ReplySentByteByByte_TimesOut()
    {
        var sent = 0;
        using var listener = new FakeTcpServer(stream =>
        {
            stream.ReadExactly(new byte[SyncFrame.Size]);
            for (; sent < SyncFrame.Size; sent++)
            {
                stream.WriteByte(0);
                // Until the client closes the connection, its next byte takes 0.3 s.
                Thread.Sleep(300);
            }
        });
        var (client, _) = Connect(listener.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => listener.Connections >= 2, "a second connection");

            Assert.That(sent, Is.LessThan(SyncFrame.Size));
        }
    }

    [Test]
    public async Task Connect_TlsHandshakeNotAnswered_TimesOutWithAReason()
    {
        using var listener = new FakeTcpServer(stream =>
        {
            while (stream.ReadByte() >= 0) { }
        });
        var (client, _) = Connect(listener.Port, CertificatePin.Parse("47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU="));
        using (client)
        {
            await Soon.BecomesAsync(() => listener.Connections >= 2, "a second connection");

            Assert.That(client.Status.Detail, Does.Contain(ConnectionMessages.NoResponse(3)));
        }
    }

    [Test]
    public async Task Exchange_ImpossibleTimes_CountsAndDropsThem()
    {
        using var server = new FakeSyncServer(request => FakeSyncServer.Bytes(Reply(request, long.MaxValue, long.MaxValue)));
        var (client, clock) = Connect(server.Port);
        using (client)
        {
            await Soon.BecomesAsync(() => _faults[SyncExchangeFault.ImplausibleTime] >= 3, "three implausible replies");

            Assert.That(clock.ModelAt(default).IsKnown, Is.False);
        }
    }

    [Test]
    public async Task Dispose_ServerDoesNotReply_EndsImmediately()
    {
        using var server = new FakeSyncServer(_ => []);
        var (client, _) = Connect(server.Port);
        await Soon.BecomesAsync(() => server.Connections == 1, "connected");

        client.Dispose();

        Assert.That(client.Status.State, Is.EqualTo(LinkState.Idle));
        await client.Ended.Bounded();
    }

    [Test]
    public async Task Exchange_SecondConnection_ReportsItsFirstResponse()
    {
        var (requests, responses) = (0, 0);
        using var server = new FakeSyncServer(request => Interlocked.Increment(ref requests) == 3 ? null : FakeSyncServer.Bytes(Reply(request)));
        using var client = new SyncClient(
            new ConnectionSettings("127.0.0.1", server.Port), new StopwatchHeadsetClock(),
            new ClockSynchroniser(new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default), _faults,
            new ExchangePace(Quick, Quick, new Random(1)), () => Interlocked.Increment(ref responses));

        await Soon.BecomesAsync(() => Volatile.Read(ref requests) > 5, "exchanges over the second connection");

        Assert.That(responses, Is.EqualTo(2));
    }

    [Test]
    public async Task Dispose_ThreadNeverEnds_ReturnsWithoutWaiting()
    {
        var clock = new StuckClock();
        using var server = new FakeSyncServer(_ => []);
        var client = new SyncClient(
            new ConnectionSettings("127.0.0.1", server.Port), clock,
            new ClockSynchroniser(new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default), _faults, new ExchangePace(Quick, Quick, new Random(1)));
        await clock.Asked.Bounded();

        client.Dispose();

        Assert.That(client.Ended.IsCompleted, Is.False);
        Assert.That(client.Status.State, Is.EqualTo(LinkState.Idle));
        clock.GoOn();
        await client.Ended.Bounded();
    }

    [Test]
    public async Task Run_PortClosed_ReportsTheFailureAndRetries()
    {
        var gone = new FakeSyncServer(_ => null);
        var port = gone.Port;
        gone.Dispose();
        var (client, _) = Connect(port);
        using (client)
        {
            await Soon.BecomesAsync(() => client.Status.State == LinkState.Waiting, "waiting");

            Assert.That(client.Status.Detail, Does.StartWith("clock sync: "));
        }
    }
}
