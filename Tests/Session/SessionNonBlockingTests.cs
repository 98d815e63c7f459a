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
    /// Maximum duration of a call, without the time during which its thread waited for a processor. It is less than all timeouts of the protocol, so that a
    /// call that waits for the other side exceeds it.
    /// </summary>
    static readonly TimeSpan Bearable = TimeSpan.FromSeconds(1.5);

    /// <summary>Maximum duration of a call on any machine.</summary>
    static readonly TimeSpan BearableWhenBusy = TimeSpan.FromSeconds(10);

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
        var watch = ProcessorPressure.StartWatch(ProcessorPressure.WaitedByThread);
        action();
        RequireQuick(watch(), Bearable, what);
    }

    static void RequireQuick((TimeSpan Elapsed, TimeSpan? WithoutWaiting) took, TimeSpan bearable, string what)
    {
        Assert.That(took.Elapsed, Is.LessThan(BearableWhenBusy), what);
        if (took.WithoutWaiting is { } own) Assert.That(own, Is.LessThan(bearable), what);
    }

    static void RequireQuick(CompensationSession session, Action meanwhile = null)
    {
        using (session)
        {
            RequireQuick(session.Connect, "connect");
            meanwhile?.Invoke();
            RequireQuick(session.Disconnect, "disconnect");
            RequireQuick(session.Connect, "connect again");
            meanwhile?.Invoke();
            RequireQuick(session.Dispose, "dispose");
        }
    }

    static void Until(Func<bool> condition, string what) => Soon.BecomesAsync(condition, what).GetAwaiter().GetResult();

    [Test]
    public async Task Session_ServerAcceptsWithoutAnswer_DoesNotBlock()
    {
        using var release = new ManualResetEventSlim();
        using var sync = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        using var webSocket = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        using var session = Session("127.0.0.1", sync.Port, webSocket.Port);

        await Task.Run(() => RequireQuick(
            session, () => Until(() => sync.Connections > 0 && webSocket.Connections > 0, "both connections")));

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
        await Soon.BecomesAsync(() => sync.Connections > 0, "waiting");
        RequireQuick(session.Dispose, "dispose");

        Assert.That(session.Statistics(default).SampleLink.State, Is.EqualTo(LinkState.Idle));
        release.Set();
    }

    [Test]
    [Platform("Linux")]
    public void Session_HostDoesNotAnswer_DoesNotBlock()
    {
        using var deaf = new UnresponsiveHost();
        using var session = Session("127.0.0.1", deaf.Port, deaf.Port);

        RequireQuick(session, () => Until(() => deaf.Dials >= 2, "both connections wait"));
    }

    [Test]
    public void Session_UnknownHostName_DoesNotBlock()
    {
        using var session = Session("gateway.invalid", 47010, 47011);

        RequireQuick(session);
    }

    [Test]
    public void Session_LinkBlocksOpenAndClose_DoesNotBlock()
    {
        using var release = new ManualResetEventSlim();
        using var sync = new FakeTcpServer(_ => release.Wait(Soon.Limit));
        var opened = 0;
        using var session = Session("127.0.0.1", sync.Port, 1, (_, _) => new BlockingLink(() => Interlocked.Increment(ref opened), release));

        RequireQuick(session, () => Until(() => sync.Connections > 0 && Volatile.Read(ref opened) > 0, "both connections wait"));

        release.Set();
    }

    [Test]
    [Platform("Linux")]
    public async Task Clients_HostDoesNotAnswer_EndShortlyAfterDispose()
    {
        using var deaf = new UnresponsiveHost();
        var clock = new StopwatchHeadsetClock();
        var settings = new ConnectionSettings("127.0.0.1", deaf.Port, deaf.Port);
        var synchroniser = new ClockSynchroniser(
            new RansacClockEstimator(RansacSettings.Paper), ClockSettings.Default);
        var sync = new SyncClient(settings, clock, synchroniser, new SyncFaultCounters(), new ExchangePace(TimeSpan.FromMilliseconds(200), TimeSpan.FromSeconds(2), new Random(1)));
        var rosbridge = new RosbridgeClient(() => WebSocketLinks.Create(settings, clock), clock, Session("127.0.0.1", 1, 1).Listener, Subscribed.ToRobot());
        await Soon.BecomesAsync(() => deaf.Dials >= 2, "both connections wait");

        var watch = ProcessorPressure.StartWatch(ProcessorPressure.Waited);
        sync.Dispose();
        rosbridge.Dispose();

        await sync.Ended.Bounded();
        await rosbridge.Ended.Bounded();
        RequireQuick(watch(), ProtocolLimits.DialTimeout / 2, "end");
    }

    /// <summary>A host that does not respond to connection requests, because its queue of connections is full.</summary>
    sealed class UnresponsiveHost : IDisposable
    {
        // The queue has space for two connections. The others wait for a response.
        const int Space = 2, Fill = 8;

        readonly Socket _listener = Bound();
        readonly Socket[] _fill = [.. Enumerable.Range(0, Fill).Select(_ => Bound())];

        public UnresponsiveHost()
        {
            _listener.Listen(Space - 1);
            var connecting = _fill.Select(socket => socket.ConnectAsync(_listener.LocalEndPoint)).ToList();
            Until(() => connecting.Count(each => each.IsCompletedSuccessfully) >= Space, "the queue of connections is full");
        }

        /// <summary>Number of connection requests of the tested code that wait for a response.</summary>
        public int Dials => File.ReadLines("/proc/net/tcp").Count(line => line.Contains($" 0100007F:{Port:X4} 02 ") && !_fill.Any(own => IsOf(own, line)));

        public int Port => PortOf(_listener);

        public void Dispose()
        {
            _listener.Dispose();
            foreach (var socket in _fill) socket.Dispose();
        }

        static Socket Bound()
        {
            var socket = new Socket(AddressFamily.InterNetwork, SocketType.Stream, ProtocolType.Tcp);
            socket.Bind(new IPEndPoint(IPAddress.Loopback, 0));
            return socket;
        }

        static int PortOf(Socket socket) => ((IPEndPoint)socket.LocalEndPoint).Port;

        // A line has the local address, the remote address and the state. 02 is the state SYN_SENT.
        static bool IsOf(Socket socket, string line) => line.Contains($": 0100007F:{PortOf(socket):X4} ");
    }

    /// <summary>A link that blocks the calling thread when it is opened or disposed.</summary>
    sealed class BlockingLink(Action opened, ManualResetEventSlim release) : IWebSocketLink
    {
        public Task OpenAsync(CancellationToken cancel)
        {
            opened();
            release.Wait(Soon.Limit, CancellationToken.None);
            return Task.FromException(new IOException("released"));
        }

        public Task SendAsync(string text, CancellationToken cancel) => Task.CompletedTask;
        public Task<string> ReceiveAsync(Action<ReceivedText> take, CancellationToken cancel) => Task.FromResult<string>(null);
        public void Dispose() => release.Wait(Soon.Limit);
    }
}
