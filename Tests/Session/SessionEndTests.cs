using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Network;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests that a frame loop's thread can end a session without waiting, in any state of the network.</summary>
public class SessionEndTests
{
    [Test]
    public async Task Dispose_NetworkBlocked_ReturnsImmediatelyAndEndsLater()
    {
        var clock = new StuckClock();
        using var silent = new FakeSyncServer(_ => []);
        using var server = new FakeWebSocketServer();
        var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1", silent.Port, server.Port), default), RobotFiles.Load("youbot"), clock);
        session.Connect();
        await clock.Asked.Bounded();

        session.Dispose();

        Assert.That(session.Ended.IsCompleted, Is.False);
        Assert.That(session.Statistics(default).SyncLink.State, Is.EqualTo(LinkState.Idle));
        clock.GoOn();
        await session.Ended.Bounded();
    }

    [Test]
    public async Task Connect_AfterDisconnect_OpensNewConnections()
    {
        using var server = new FakeWebSocketServer();
        var clock = new StopwatchHeadsetClock();
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1", 1, server.Port), default), RobotFiles.Load("youbot"), clock);

        session.Connect();
        await server.AcceptAsync();
        session.Disconnect();
        session.Connect();
        await server.AcceptAsync();
        session.Disconnect();

        await session.Ended.Bounded();
        Assert.That(session.Statistics(clock.Now).SampleLink.State, Is.EqualTo(LinkState.Idle));
    }
}
