using System.Diagnostics;
using System.Net;
using System.Net.Sockets;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Network;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using Nowpose.Sync.Ransac;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests that connecting and disconnecting do not block the main thread for long in any state of the gateway.</summary>
public class SessionNonBlockingTests
{
    /// <summary>
    /// Maximum duration of a call. It is less than all timeouts of the protocol, so that a call that waits for the other side exceeds it, and much
    /// more than the delays of a busy machine.
    /// </summary>
    static readonly TimeSpan Bearable = TimeSpan.FromSeconds(1.5);

    [SetUp]
    public void Precondition() => Assert.That(
        new[] { ProtocolLimits.SyncReplyTimeout, ProtocolLimits.DialTimeout, ProtocolLimits.PongTimeout }.Min(), Is.GreaterThan(Bearable));

    static CompensationSession Session(
        string host, int syncPort, int webSocketPort, Func<ConnectionSettings, IHeadsetClock, IWebSocketLink> newLink = null) =>
        new(
            new SessionSettings(
                new ConnectionSettings(host, syncPort, webSocketPort, insecureLan: true), new VisualisationLatency(TimeSpan.FromMilliseconds(40))),
            RobotFiles.Load("youbot"), new StopwatchHeadsetClock(), newLink ?? WebSocketLinks.Create);

    static void RequireQuick(Action action, string what)
    {
        var since = Stopwatch.GetTimestamp();
        action();
        Assert.That(Stopwatch.GetElapsedTime(since), Is.LessThan(Bearable), what);
    }

    static void RequireQuick(CompensationSession session, Action meanwhile)
    {
        using (session)
        {
            RequireQuick(session.Connect, "connect");
            meanwhile();
            RequireQuick(session.Disconnect, "disconnect");
            RequireQuick(session.Connect, "connect again");
            meanwhile();
            RequireQuick(session.Dispose, "dispose");
        }
    }

    // Gives the connections time to start waiting for a response. No event indicates when they wait.
    static void AMoment() => Thread.Sleep(50);

    [Test]
    public async Task Session_ServerAcceptsWithoutAnswer_DoesNotBlock()
    {
        using var release = new ManualResetEventSlim();
        using var sync = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        using var webSocket = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        using var session = Session("127.0.0.1", sync.Port, webSocket.Port);

        await Task.Run(() => RequireQuick(session, () =>
        {
            Soon.BecomesAsync(() => sync.Connections > 0 && webSocket.Connections > 0, "both connections").GetAwaiter().GetResult();
            AMoment();
        }));

        release.Set();
    }

    [Test]
    public async Task Session_ServerUpgradesWithoutMessages_DoesNotBlock()
    {
        using var release = new ManualResetEventSlim();
        using var sync = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        using var webSocket = new FakeWebSocketServer();
        using var session = Session("127.0.0.1", sync.Port, webSocket.Port);

        RequireQuick(session.Connect, "connect");
        await webSocket.AcceptStreamAsync();
        await Soon.BecomesAsync(() => session.Statistics(default).SyncLink.State == LinkState.Connecting && sync.Connections > 0, "waiting");
        RequireQuick(session.Dispose, "dispose");

        Assert.That(session.Statistics(default).SampleLink.State, Is.EqualTo(LinkState.Idle));
        release.Set();
    }

    [Test]
    public void Session_HostDoesNotAnswer_DoesNotBlock()
    {
        using var deaf = new UnresponsiveHost();
        using var session = Session("127.0.0.1", deaf.Port, deaf.Port);

        RequireQuick(session, AMoment);
    }

    [Test]
    public void Session_UnknownHostName_DoesNotBlock()
    {
        using var session = Session("gateway.invalid", 47010, 47011);

        RequireQuick(session, AMoment);
    }

    [Test]
    public void Session_LinkBlocksOpenAndClose_DoesNotBlock()
    {
        using var release = new ManualResetEventSlim();
        using var sync = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        using var session = Session("127.0.0.1", sync.Port, 1, (_, _) => new BlockingLink(release));

        RequireQuick(session, AMoment);

        release.Set();
    }

    [Test]
    public async Task Clients_HostDoesNotAnswer_EndShortlyAfterDispose()
    {
        using var deaf = new UnresponsiveHost();
        var clock = new StopwatchHeadsetClock();
        var settings = new ConnectionSettings("127.0.0.1", deaf.Port, deaf.Port);
        var synchroniser = new ClockSynchroniser(
            new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default);
        var sync = new SyncClient(settings, clock, synchroniser, new SyncFaultCounters(), new ExchangePace(TimeSpan.FromMilliseconds(200), TimeSpan.FromSeconds(2), new Random(1)));
        var rosbridge = new RosbridgeClient(() => WebSocketLinks.Create(settings, clock), clock, Session("127.0.0.1", 1, 1).Listener, Subscribed.ToRobot());
        await Task.Run(AMoment);

        sync.Dispose();
        rosbridge.Dispose();

        await sync.Ended.WaitAsync(ProtocolLimits.DialTimeout / 2);
        await rosbridge.Ended.WaitAsync(ProtocolLimits.DialTimeout / 2);
    }

    /// <summary>A host that does not respond to connection requests, because its queue of connections is full.</summary>
    sealed class UnresponsiveHost : IDisposable
    {
        readonly Socket _listener = new(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
        readonly List<Socket> _fill = [];

        public UnresponsiveHost()
        {
            _listener.Bind(new IPEndPoint(IPAddress.Loopback, 0));
            _listener.Listen(1);
            while (_fill.Count < 16 && Connects()) { }
        }

        public int Port => ((IPEndPoint)_listener.LocalEndPoint).Port;

        public void Dispose()
        {
            _listener.Dispose();
            foreach (var socket in _fill) socket.Dispose();
        }

        bool Connects()
        {
            var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            _fill.Add(socket);
            return socket.ConnectAsync(_listener.LocalEndPoint).Wait(200);
        }
    }

    /// <summary>A link that blocks the calling thread when it is opened or disposed.</summary>
    sealed class BlockingLink(ManualResetEventSlim release) : IWebSocketLink
    {
        public Task OpenAsync(CancellationToken cancel)
        {
            release.Wait(Soon.Limit, CancellationToken.None);
            return Task.FromException(new IOException("released"));
        }

        public Task SendAsync(string text, CancellationToken cancel) => Task.CompletedTask;
        public Task ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel) => Task.CompletedTask;
        public void Dispose() => release.Wait(Soon.Limit);
    }
}
