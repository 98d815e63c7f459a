using System.Net.WebSockets;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Plants;
using Nowpose.Messages;
using Nowpose.Motion;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Simulation.Work;
using Nowpose.Unity;
using Nowpose.Unity.Messages;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Session;

/// <summary>Tests the session component with real sockets. No frame may wait for a socket.</summary>
public class SessionConnectionTests
{
    PlayedCell _cell;

    [SetUp]
    public void Start() => _cell = new PlayedCell();

    [TearDown]
    public void Stop() => _cell.Dispose();

    static SessionSettings To(int syncPort, int webSocketPort) =>
        new(new ConnectionSettings("127.0.0.1", syncPort, webSocketPort), PlayedCell.Offline.Visualisation);

    [Test]
    public async Task Connect_Gateway_ShowsItsRobotAtItsTruePose()
    {
        var control = StopwatchControlClock.FromUnixTime();
        using var plant = new SimulatedCell(
            new CellMotion(new PickAndPlaceMotion(RobotFiles.Load("ur5"))), control,
            new CellTiming(TimeSpan.FromMilliseconds(50), TimeSpan.FromMilliseconds(10), TimeSpan.FromMilliseconds(20)), seed: 1);
        await using var gateway = await GatewayServer.StartAsync(new GatewayOptions { SyncPort = 0, WebSocketPort = 0 }, control);
        using var robot = gateway.Hub.OpenSource();
        Assert.That(robot.Describe(RobotFiles.LoadText("ur5")), Is.Null);
        plant.PublishInto(gateway.Hub);
        var session = _cell.NewSession(robot: null, To(gateway.SyncEndPoint.Port, gateway.WebSocketEndPoint.Port)).With("_connectOnEnable", true);
        session.HeadsetClock = new StopwatchHeadsetClock();
        var rig = new GameObject("Robot").AddComponent<RobotRig>();
        rig.transform.SetParent(session.transform, false);

        session.gameObject.SetActive(true);
        await SoonAsync(session, () => session.Frame?.State == PoseState.Current, "current");

        Assert.That(rig.Model.Name, Is.EqualTo("ur5"));
        Assert.That(rig.Joints.ToArray(), Is.EqualTo(session.Frame.Joints.ToArray()));
        Assert.That(_cell.Messages.Count(m => m.EndsWith(": connected", StringComparison.Ordinal)), Is.GreaterThanOrEqualTo(2));
        Assert.That(_cell.Messages.Count(m => m.EndsWith(SessionMessages.FirstPositions, StringComparison.Ordinal)), Is.EqualTo(1));
    }

    // The line about the connection must not suggest that positions arrive.
    [Test]
    public async Task Connected_NoJointPositions_LogsOnlyTheConnection()
    {
        using var server = new FakeWebSocketServer();
        var session = _cell.Play(settings: To(1, server.Port));
        session.Connect();
        using var socket = await server.AcceptAsync();

        await socket.SendAsync(
            Encoding.UTF8.GetBytes(RosbridgeWriter.Status("info", "hello")), WebSocketMessageType.Text, true, CancellationToken.None);
        await SoonAsync(session, () => session.Session.SampleLink.State == LinkState.Connected, "connected");
        _cell.Frame(null);

        Assert.That(_cell.Messages, Has.One.EndsWith("gateway: connected"));
        Assert.That(_cell.Messages, Has.None.Contain("joint positions"));
    }

    [Test]
    public async Task Connect_ConnectionRefused_IsLoggedOncePerConnection()
    {
        var session = _cell.Play(settings: To(1, 1));

        session.Connect();
        var tries = 0;
        var status = default(LinkStatus);
        await SoonAsync(session, () => (tries += Changed(session.Session.SampleLink, ref status) ? 1 : 0) >= 4, "four connection attempts");
        await SoonAsync(session, () => session.Session.SyncLink.State == LinkState.Waiting, "waiting");
        _cell.Frame(null);

        Assert.That(_cell.Messages.Count(m => m.Contains("clock sync")), Is.EqualTo(1), string.Join('\n', _cell.Messages));
        Assert.That(_cell.Messages.Count(m => m.Contains("joint positions")), Is.EqualTo(1));
        Assert.That(_cell.Player.Logs.Select(log => log.Type), Is.All.EqualTo(LogType.Warning));
    }

    [Test]
    public async Task Connected_GatewayReportsAnError_IsLoggedAsAWarningOnce()
    {
        using var server = new FakeWebSocketServer();
        var session = _cell.Play(settings: To(1, server.Port));
        session.Connect();
        using var socket = await server.AcceptAsync();

        for (var i = 0; i < 3; i++)
            await socket.SendAsync(
                Encoding.UTF8.GetBytes(RosbridgeWriter.Status("error", "the name is taken")), WebSocketMessageType.Text, true, CancellationToken.None);
        await SoonAsync(session, () => session.Session.SampleLink.Warning != null, "a warning");
        _cell.Frame(null);

        Assert.That(_cell.Player.Logs.Count(log =>
            log.Type == LogType.Warning && log.Message.Contains(ConnectionMessages.Reported("the name is taken"))), Is.EqualTo(1), string.Join('\n', _cell.Messages));
    }

    [Test]
    public async Task Pause_NetworkIsBlocked_ReturnsImmediately()
    {
        using var silent = new FakeSyncServer(_ => []);
        using var server = new FakeWebSocketServer();
        var clock = new StuckClock();
        var session = _cell.NewSession(settings: To(silent.Port, server.Port)).With("_connectOnEnable", true);
        session.HeadsetClock = clock;
        session.gameObject.SetActive(true);
        await clock.Asked.Bounded();
        var ended = session.Session;

        _cell.Player.Pause(true);

        Assert.That(session.Session, Is.Null);
        Assert.That(ended.Ended.IsCompleted, Is.False, "disabling the session does not wait for a blocked connection");
        clock.GoOn();
        await ended.Ended.Bounded();
    }

    [TestCase("pause")]
    [TestCase("disable")]
    [TestCase("destroy")]
    public async Task SessionEnd_Connected_ClosesTheSockets(string how)
    {
        using var server = new FakeWebSocketServer();
        var session = _cell.NewSession(settings: To(1, server.Port)).With("_connectOnEnable", true);
        session.gameObject.SetActive(true);
        var accepted = await server.AcceptStreamAsync();
        var ended = session.Session;

        if (how == "pause") _cell.Player.Pause(true);
        else if (how == "disable") session.enabled = false;
        else UnityEngine.Object.Destroy(session.gameObject);
        _cell.Frame(null);

        await ReadToEndAsync(accepted).Bounded();
        await ended.Ended.Bounded();
        if (how != "pause") return;
        _cell.Player.Pause(false);
        await server.AcceptStreamAsync();
    }

    [Test]
    public async Task Pause_AfterDisconnect_StaysDisconnected()
    {
        using var server = new FakeWebSocketServer();
        var session = _cell.NewSession(settings: To(1, server.Port)).With("_connectOnEnable", true);
        session.gameObject.SetActive(true);
        var accepted = await server.AcceptStreamAsync();

        session.Disconnect();
        await ReadToEndAsync(accepted).Bounded();
        _cell.Player.Pause(true);
        _cell.Player.Pause(false);
        Assert.That(session.Session.SampleLink.State, Is.EqualTo(LinkState.Idle));

        session.Connect();
        await server.AcceptStreamAsync();
    }

    static bool Changed(LinkStatus now, ref LinkStatus before)
    {
        var changed = !ReferenceEquals(now, before) && now.State == LinkState.Waiting;
        before = now;
        return changed;
    }

    static async Task ReadToEndAsync(Stream stream)
    {
        var buffer = new byte[4096];
        try
        {
            while (await stream.ReadAsync(buffer) > 0)
            {
            }
        }
        catch (IOException)
        {
            // The peer reset the connection instead of closing it. This also ends the connection.
        }
    }

    // Runs frames without pauses until a condition is true. Fails if a frame takes as long as a wait for the network would take.
    async Task SoonAsync(MrilSession session, Func<bool> condition, string what)
    {
        await Soon.BecomesAsync(() =>
        {
            _cell.Frame(null);
            return session.Session != null && condition();
        }, what);
    }

    // Each new connection reports the mismatch again.
    [Test]
    public void VersionMismatch_ReportedByTwoConnections_IsLoggedOnce()
    {
        var session = _cell.Play();

        for (var i = 0; i < 2; i++)
        {
            session.Session.Listener.VersionReceived("9.9.9");
            _cell.Run(0.1, session);
        }

        Assert.That(_cell.Messages, Has.Exactly(1).EndsWith(NowposeVersion.MismatchOf("9.9.9", "the gateway", "this headset")));
    }
}
