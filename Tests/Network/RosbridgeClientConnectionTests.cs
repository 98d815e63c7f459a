using System.Collections.Concurrent;
using System.Diagnostics;
using System.Net.WebSockets;
using System.Text;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Network.PlayedServer;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Tests how a client connects, subscribes, reconnects and ends.</summary>
public class RosbridgeClientConnectionTests
{
    PlayedServer _played;

    [SetUp]
    public void Start() => _played = new PlayedServer();

    [TearDown]
    public void Stop() => _played.Dispose();

    [Test]
    public async Task Connect_Server_SubscribesAndReceivesMessages()
    {
        var socket = await _played.Server.AcceptAsync();
        var buffer = new byte[4096];
        var first = await socket.ReceiveAsync(buffer, CancellationToken.None);

        await Send(socket, Good);

        Assert.That(Encoding.UTF8.GetString(buffer, 0, first.Count), Does.Contain("\"subscribe\"").And.Contain("/joint_states"));
        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Connected, "connected");
        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "a message");
        Assert.That(_played.Listener.Messages.Single().Positions, Is.EqualTo(new[] { 1.5 }));
        Assert.That(_played.Client.Status.State, Is.EqualTo(LinkState.Connected));
    }

    [Test]
    public async Task Receive_ConnectionClosedAfterVersion_ReportsTheNextConnection()
    {
        using (var first = await _played.Server.AcceptAsync())
        {
            await Send(first, RosbridgeWriter.Publish(RosTopics.Version, new StringMessage("9.9.9")));
            await Soon.BecomesAsync(() => !_played.Listener.Versions.IsEmpty, "the version");
            Assert.That(_played.Listener.Connections, Has.Count.EqualTo(1), "reported before the first message");
            await first.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, "", CancellationToken.None);
        }

        using var second = await _played.Server.AcceptAsync();

        await Soon.BecomesAsync(() => _played.Listener.Connections.Count == 2, "a new connection");
        Assert.That(_played.Listener.Connections, Is.Ordered.Ascending);
    }

    [Test]
    public async Task Receive_IncompleteMessage_ClosesAndReconnects()
    {
        var socket = await _played.Server.AcceptAsync();
        await Send(socket, "{\"op\":", end: false);

        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Waiting, "waiting");

        Assert.That(_played.Client.Status.Detail, Does.Contain(ConnectionMessages.MessageTooSlow(5)));
        Assert.That(_played.Listener.Drops, Is.EqualTo(new[] { DropReason.TooSlow }));
        await Send(await _played.Server.AcceptAsync(), Good);
        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "a message over the new connection");
    }

    [Test]
    public async Task Receive_NothingForSixSeconds_ClosesAndReconnects()
    {
        var stream = await _played.Server.AcceptStreamAsync();

        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Waiting, "waiting");

        Assert.That(_played.Client.Status.Detail, Does.Contain(ConnectionMessages.NothingReceived(6)));
        var sent = new byte[4096];
        Assert.That(stream.Read(sent), Is.GreaterThan(0), "the client had sent its request");
        await Send(await _played.Server.AcceptAsync(), Good);
        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "a message over the new connection");
    }

    [TestCase("")]
    [TestCase("SlowReader")]
    public async Task Receive_ServerClosesTheConnection_StatusStatesTheReason(string reason)
    {
        var socket = await _played.Server.AcceptAsync();

        await socket.CloseOutputAsync(WebSocketCloseStatus.PolicyViolation, reason, CancellationToken.None);

        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Waiting, "waiting");
        Assert.That(_played.Client.Status.Detail, Is.EqualTo("joint positions: " + ConnectionMessages.Closed(reason)).And.Contains(reason));
    }

    [Test]
    public async Task Receive_StatusOfLevelError_IsTheWarningOfTheConnection()
    {
        using (var socket = await _played.Server.AcceptAsync())
        {
            await Send(socket, RosbridgeWriter.Status("error", "publish: dropped: the name is taken"));

            await Soon.BecomesAsync(() => _played.Client.Status.Warning != null, "a warning");
            Assert.That(_played.Client.Status.State, Is.EqualTo(LinkState.Connected));
            Assert.That(_played.Client.Status.Warning, Is.EqualTo(ConnectionMessages.Reported("publish: dropped: the name is taken")));
            Assert.That(_played.Client.Status.Detail, Does.EndWith(_played.Client.Status.Warning));
            await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, "", CancellationToken.None);
        }

        await Send(await _played.Server.AcceptAsync(), Good);

        await Soon.BecomesAsync(() => _played.Client.Status is { State: LinkState.Connected, Warning: null }, "a connection without errors");
    }

    [TestCase("HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n", "token")]
    [TestCase("HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\n\r\n", "origin")]
    [TestCase("HTTP/1.1 503 Service Unavailable\r\nContent-Length: 0\r\n\r\n", "(503)")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n", "200")]
    public async Task Connect_UpgradeRefused_StatesTheReason(string answer, string named)
    {
        await _played.Server.AnswerAsync(answer);

        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Waiting && _played.Client.Status.Detail.Contains(named), named);
    }

    [TestCase("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: bm9uc2Vuc2U=\r\n\r\n")]
    [TestCase("SSH-2.0-OpenSSH_9.2\r\n\r\n")]
    public async Task Connect_ServerIsNotAGateway_StatesTheReasonAndRetries(string answer)
    {
        await _played.Server.AnswerAsync(answer);

        await Soon.BecomesAsync(() => _played.Client.Status.State == LinkState.Waiting, "waiting");
        Assert.That(_played.Client.Status.Detail, Does.StartWith("joint positions: "));
    }

    [TestCase(false)]
    [TestCase(true)]
    public async Task Connect_ServerAcceptsAndCloses_IncreasesTheRetryDelay(bool sendsAMessage)
    {
        for (var i = 0; i < 3; i++) await CloseAsync();
        var since = Stopwatch.StartNew();
        await CloseAsync();

        (await _played.Server.AcceptStreamAsync()).Close();

        async Task CloseAsync()
        {
            using var socket = await _played.Server.AcceptAsync();
            if (sendsAMessage) await Send(socket, Good);
        }

        Assert.That(since.Elapsed, Is.GreaterThan(TimeSpan.FromSeconds(1)), "the three delays of 0.2, 0.4 and 0.8 s have passed");
    }

    [Test]
    public async Task Diagnostics_ProviderThrows_EndsOnlyTheConnection()
    {
        _played.Listener.FailDiagnostics = true;
        await _played.Server.AcceptStreamAsync();

        await Soon.BecomesAsync(() => _played.Client.Status.Detail.Contains("no diagnostics today"), "the status contains the reason");
        _played.Listener.FailDiagnostics = false;
        await Send(await _played.Server.AcceptAsync(), Good);
        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 1, "a message over the new connection");
    }

    [Test]
    public async Task Connect_Server_SubscribesToSetPointsAndDescription()
    {
        var socket = await _played.Server.AcceptAsync();
        var buffer = new byte[4096];
        await socket.ReceiveAsync(buffer, CancellationToken.None);

        var second = Encoding.UTF8.GetString(buffer, 0, (await socket.ReceiveAsync(buffer, CancellationToken.None)).Count);
        var third = Encoding.UTF8.GetString(buffer, 0, (await socket.ReceiveAsync(buffer, CancellationToken.None)).Count);
        var fourth = Encoding.UTF8.GetString(buffer, 0, (await socket.ReceiveAsync(buffer, CancellationToken.None)).Count);

        Assert.That(second, Is.EqualTo("""{"op":"subscribe","topic":"/joint_trajectory","type":"trajectory_msgs/JointTrajectory"}"""));
        Assert.That(third, Is.EqualTo("""{"op":"subscribe","topic":"/robot_description","type":"std_msgs/String"}"""));
        Assert.That(fourth, Is.EqualTo("""{"op":"subscribe","topic":"/nowpose/joint_status","type":"diagnostic_msgs/DiagnosticArray"}"""));
    }

    [Test]
    public async Task Connect_WithDisplayedJoints_AdvertisesAndPublishesThem()
    {
        _played.Listener.Displays.Enqueue(new JointStateMessage(ControlTime.FromSeconds(5), ["a"], [0.5], frameId: "left door"));
        var socket = await _played.Server.AcceptAsync();

        Assert.That(await NextAsync(socket, "advertise", RosTopics.Diagnostics), Does.Contain(RosTopics.DiagnosticsType));
        Assert.That(await NextAsync(socket, "advertise", RosTopics.Displayed), Does.Contain(RosTopics.JointStateType));
        Assert.That(RosbridgeReader.TryRead(await NextAsync(socket, "publish", RosTopics.Displayed), out var message, out _), Is.True);
        Assert.That(message.Displayed.FrameId, Is.EqualTo("left door"));
        Assert.That(message.Displayed.Positions, Is.EqualTo(new[] { 0.5 }));
        Assert.That(message.JointState, Is.Null, "a displayed pose is not a sample of the robot");
    }

    [Test]
    public async Task Connect_PublishingDisplayedJointsDisabled_DoesNotAdvertiseThem()
    {
        using var server = new FakeWebSocketServer();
        var clock = new StopwatchHeadsetClock();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: server.Port, publishesDisplayed: false);
        _played.Listener.Displays.Enqueue(new JointStateMessage(ControlTime.FromSeconds(5), ["a"], [0.5], frameId: "left door"));
        _played.Listener.Report = new DiagnosticsMessage(default, "left door", []);
        using var client = new RosbridgeClient(
            () => WebSocketLinks.Create(settings, clock), clock, _played.Listener, Subscribed.ToRobot(), settings.PublishesDisplayed);
        var socket = await server.AcceptAsync();

        var sent = new List<string>();
        while (!sent.Any(text => text.Contains("\"publish\""))) sent.Add(await ReceiveAsync(socket));

        Assert.That(sent, Has.None.Contains(RosTopics.Displayed));
        Assert.That(_played.Listener.Displays, Has.Count.EqualTo(1));
    }

    [TestCase(true, true, 0.2)]
    [TestCase(false, true, 0.2)]
    [TestCase(true, false, 1)]
    public async Task Diagnostics_PoseChangedOrNot_AreSentAtTheIntervalOfTheState(bool publishesDisplayed, bool hasPoseChanged, double intervalSeconds)
    {
        const double ReadingSeconds = 0.05;
        using var server = new FakeWebSocketServer();
        // Each reading advances this clock, so the delays of a busy machine have no effect.
        var clock = new SteppedClock { Step = TimeSpan.FromSeconds(ReadingSeconds) };
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: server.Port, publishesDisplayed: publishesDisplayed);
        var times = new ConcurrentQueue<HeadsetTime>();
        _played.Listener.Report = new DiagnosticsMessage(default, "left door", []);
        _played.Listener.HasPoseChanged = hasPoseChanged;
        _played.Listener.Reporting = () => times.Enqueue(clock.Read);
        using var client = new RosbridgeClient(
            () => WebSocketLinks.Create(settings, clock), clock, _played.Listener, Subscribed.ToRobot(), settings.PublishesDisplayed);
        var socket = await server.AcceptAsync();

        for (var i = 0; i < 3; i++) await NextAsync(socket, "publish", RosTopics.Diagnostics);

        var intervals = times.Zip(times.Skip(1), (one, next) => (next - one).TotalSeconds).Take(2).ToList();
        Assert.That(intervals, Has.Count.EqualTo(2).And.All.InRange(intervalSeconds, intervalSeconds + 4 * ReadingSeconds));
    }

    static async Task<string> NextAsync(WebSocket socket, string op, string topic)
    {
        while (true)
        {
            var text = await ReceiveAsync(socket);
            if (text.Contains($"\"{op}\"") && text.Contains($"\"{topic}\"")) return text;
        }
    }

    [Test]
    public async Task Dispose_WhileConnected_EndsImmediately()
    {
        await _played.Server.AcceptAsync();

        _played.Client.Dispose();

        Assert.That(_played.Client.Status.State, Is.EqualTo(LinkState.Idle));
        await _played.Client.Ended.Bounded();
    }

    [Test]
    public async Task Dispose_ThreadBlocked_ReturnsWithoutWaiting()
    {
        await _played.Server.AcceptAsync();
        var clock = new StuckClock();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: _played.Server.Port);
        var client = new RosbridgeClient(() => WebSocketLinks.Create(settings, clock), clock, _played.Listener, Subscribed.ToRobot());
        await _played.Server.AcceptAsync();
        await clock.Asked.Bounded();

        client.Dispose();

        Assert.That(client.Ended.IsCompleted, Is.False);
        clock.GoOn();
        await client.Ended.Bounded();
    }
}
