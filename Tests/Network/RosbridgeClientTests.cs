using System.Collections.Concurrent;
using System.Net.Sockets;
using System.Net.WebSockets;
using System.Text;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

/// <summary>How the headset handles valid and invalid messages of a server.</summary>
public class RosbridgeClientTests
{
    const string Good = """{"op":"publish","topic":"/joint_states","msg":{"header":{"stamp":{"secs":5,"nsecs":0}},"name":["a"],"position":[1.5]}}""";

    FakeWebSocketServer _server;
    Listener _listener;
    RosbridgeClient _client;

    [SetUp]
    public void Start()
    {
        _server = new FakeWebSocketServer();
        _listener = new Listener();
        var clock = new StopwatchHeadsetClock();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: _server.Port);
        _client = new RosbridgeClient(() => WebSocketLinks.Create(settings, clock), clock, _listener);
    }

    [TearDown]
    public void Stop()
    {
        _client.Dispose();
        _server.Dispose();
    }

    static Task Send(WebSocket socket, string text, WebSocketMessageType type = WebSocketMessageType.Text, bool end = true) =>
        socket.SendAsync(Encoding.UTF8.GetBytes(text), type, end, CancellationToken.None);

    [Test]
    public async Task Connect_Server_SubscribesAndReceivesMessages()
    {
        var socket = await _server.AcceptAsync();
        var buffer = new byte[4096];
        var first = await socket.ReceiveAsync(buffer, CancellationToken.None);

        await Send(socket, Good);

        Assert.That(Encoding.UTF8.GetString(buffer, 0, first.Count), Does.Contain("\"subscribe\"").And.Contain("/joint_states"));
        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Connected, "connected");
        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "a message");
        Assert.That(_listener.Messages.Single().Positions, Is.EqualTo(new[] { 1.5 }));
        Assert.That(_client.Status.State, Is.EqualTo(LinkState.Connected));
    }

    const string JointStatus = """
        {"op":"publish","topic":"/nowpose/joint_status","msg":{"status":[{"name":"joints","hardware_id":"gateway","values":[{"key":"a3","value":"fault 5.250 node deleted"}]}]}}
        """;

    [Test]
    public async Task Receive_JointStatus_IsPassedOnAndAMalformedOneIsCounted()
    {
        var socket = await _server.AcceptAsync();

        await Send(socket, JointStatus.Replace("fault", "broken"));
        await Send(socket, JointStatus);

        await Soon.BecomesAsync(() => _listener.Statuses.Count == 1, "the good message");
        var joint = _listener.Statuses.Single().Joints.Single();
        Assert.That((joint.Joint, joint.State, joint.Reason), Is.EqualTo(("a3", JointDataState.Fault, "node deleted")));
        Assert.That(_listener.Drops, Is.EqualTo(new[] { DropReason.OutOfRange }));
    }

    static IEnumerable<TestCaseData> BadMessages()
    {
        yield return new TestCaseData("not json at all", DropReason.NotJson);
        yield return new TestCaseData(Good.Replace("1.5", "NaN"), DropReason.NotFinite);
        yield return new TestCaseData(Good.Replace("[1.5]", "[1.5,2]"), DropReason.LengthMismatch);
        yield return new TestCaseData(new string('[', 10_000) + new string(']', 10_000), DropReason.NotJson);
        yield return new TestCaseData("{\"a\":" + new string('[', 10_000) + new string(']', 10_000) + "}", DropReason.TooDeep);
        yield return new TestCaseData("{\"op\":\"" + new string('x', 2_000_000) + "\"}", DropReason.TooLarge);
        yield return new TestCaseData(Good.Replace("\"secs\":5", "\"secs\":0"), DropReason.StampZero);
    }

    [TestCaseSource(nameof(BadMessages))]
    public async Task Receive_InvalidMessage_IsCountedAndTheNextIsPassedOn(string message, object reason)
    {
        var socket = await _server.AcceptAsync();

        await Send(socket, message);
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "the good message");
        Assert.That(_listener.Drops, Is.EqualTo(new[] { (DropReason)reason }));
    }

    [Test]
    public async Task Receive_BinaryMessage_IsDropped()
    {
        var socket = await _server.AcceptAsync();

        await Send(socket, Good, WebSocketMessageType.Binary);
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "the good message");
        Assert.That(_listener.Drops, Is.EqualTo(new[] { DropReason.NotJson }));
    }

    [TestCase(64, true)]
    [TestCase(65, false)]
    public async Task Receive_ManyFragments_AcceptsThemUpToTheLimit(int fragments, bool taken)
    {
        var socket = await _server.AcceptAsync();
        var perFragment = Good.Length / (fragments - 1);

        for (var i = 0; i < fragments - 1; i++)
            await Send(socket, Good.Substring(i * perFragment, perFragment), end: false);
        await Send(socket, Good[((fragments - 1) * perFragment)..]);
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _listener.Messages.Count == (taken ? 2 : 1), "the good messages");
        Assert.That(_listener.Drops, taken ? Is.Empty : Is.EqualTo(new[] { DropReason.TooManyFragments }));
    }

    [Test]
    public async Task Receive_LongFrameInSmallSegments_IsNotCountedAsFragments()
    {
        var stream = await _server.AcceptStreamAsync();
        var padded = Good.Replace("\"op\"", "\"padding\":\"" + new string('x', 60_000) + "\",\"op\"");
        var payload = Encoding.UTF8.GetBytes(padded);

        stream.Write([0x81, 126, (byte)(payload.Length >> 8), (byte)payload.Length]);
        for (var at = 0; at < payload.Length; at += 600)
        {
            stream.Write(payload, at, Math.Min(600, payload.Length - at));
            if (at % 3000 == 0) await Task.Delay(1);
        }

        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "the message");
    }

    [Test]
    public async Task Receive_IncompleteMessage_ClosesAndReconnects()
    {
        var socket = await _server.AcceptAsync();
        await Send(socket, "{\"op\":", end: false);

        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Waiting, "waiting");

        Assert.That(_client.Status.Detail, Does.Contain("not complete within 5 s"));
        Assert.That(_listener.Drops, Is.EqualTo(new[] { DropReason.TooSlow }));
        await Send(await _server.AcceptAsync(), Good);
        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "a message over the new connection");
    }

    [Test]
    public async Task Receive_NothingForSixSeconds_ClosesAndReconnects()
    {
        var stream = await _server.AcceptStreamAsync();

        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Waiting, "waiting");

        Assert.That(_client.Status.Detail, Does.Contain("received nothing for 6 s"));
        var sent = new byte[4096];
        Assert.That(stream.Read(sent), Is.GreaterThan(0), "it had asked");
        await Send(await _server.AcceptAsync(), Good);
        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "a message over the new connection");
    }

    [Test]
    public async Task Receive_ServerCloses_StatesItInTheStatus()
    {
        var socket = await _server.AcceptAsync();

        await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, "", CancellationToken.None);

        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Waiting, "waiting");
        Assert.That(_client.Status.Detail, Is.EqualTo("joint positions: the gateway closed the connection"));
    }

    [Test]
    public async Task Receive_CompressedFrame_ClosesWithAnError()
    {
        var stream = await _server.AcceptStreamAsync();

        stream.Write([0xC1, 2, (byte)'{', (byte)'}']);

        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Waiting, "waiting");
    }

    [TestCase("HTTP/1.1 401 Unauthorized\r\nContent-Length: 0\r\n\r\n", "token")]
    [TestCase("HTTP/1.1 403 Forbidden\r\nContent-Length: 0\r\n\r\n", "origin")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n", "200")]
    public async Task Connect_Refused_StatesTheReason(string answer, string named)
    {
        await _server.AnswerAsync(answer);

        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Waiting && _client.Status.Detail.Contains(named), named);
    }

    [TestCase("HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: bm9uc2Vuc2U=\r\n\r\n")]
    [TestCase("SSH-2.0-OpenSSH_9.2\r\n\r\n")]
    public async Task Connect_NotAGateway_RetriesAndStatesTheReason(string answer)
    {
        await _server.AnswerAsync(answer);

        await Soon.BecomesAsync(() => _client.Status.State == LinkState.Waiting, "waiting");
        Assert.That(_client.Status.Detail, Does.StartWith("joint positions: "));
    }

    [Test]
    public async Task Connect_ServerAcceptsAndCloses_IncreasesTheRetryDelay()
    {
        for (var i = 0; i < 3; i++) (await _server.AcceptStreamAsync()).Close();
        var fourth = await _server.AcceptStreamAsync();
        var since = System.Diagnostics.Stopwatch.StartNew();
        fourth.Close();

        (await _server.AcceptStreamAsync()).Close();

        Assert.That(since.Elapsed, Is.GreaterThan(TimeSpan.FromSeconds(1)), "0.2, 0.4, 0.8 s are over");
    }

    [Test]
    public async Task Diagnostics_Throws_EndsTheConnectionButNotTheClient()
    {
        _listener.FailDiagnostics = true;
        await _server.AcceptStreamAsync();

        await Soon.BecomesAsync(() => _client.Status.Detail.Contains("no diagnostics today"), "the reason");
        _listener.FailDiagnostics = false;
        await Send(await _server.AcceptAsync(), Good);
        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "a message over the new connection");
    }

    [Test]
    public async Task Connect_Server_SubscribesToSetPointsAndDescription()
    {
        var socket = await _server.AcceptAsync();
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
    public async Task Receive_SetPoints_ArePassedOn()
    {
        var socket = await _server.AcceptAsync();

        await Send(socket, RosbridgeWriter.PublishJointTrajectory(RosTopics.JointTrajectory, new JointTrajectoryMessage(
            ControlTime.FromSeconds(5), ["a"], [new JointTrajectoryPoint(TimeSpan.FromSeconds(1), [0.5], [0.25], [-1])]), RosTimeForm.Sec));

        await Soon.BecomesAsync(() => _listener.Plans.Count == 1, "set-points");
        Assert.That(_listener.Plans.Single().Points[0].Accelerations, Is.EqualTo(new[] { -1.0 }));
    }

    [Test]
    public async Task Receive_DescriptionOfNearlyOneMebibyte_IsPassedOn()
    {
        var socket = await _server.AcceptAsync();
        var urdf = new string('x', ProtocolLimits.DescriptionBytes - 100);

        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, urdf));

        await Soon.BecomesAsync(() => _listener.Descriptions.Count == 1, "a description");
        Assert.That(_listener.Descriptions.Single(), Is.EqualTo(urdf));
    }

    [Test]
    public async Task Receive_DescriptionBeyondOneMebibyte_IsDropped()
    {
        var socket = await _server.AcceptAsync();

        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, new string('x', ProtocolLimits.DescriptionBytes)));
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "the good message");
        Assert.That(_listener.Drops, Is.EqualTo(new[] { DropReason.TooLarge }));
        Assert.That(_listener.Descriptions, Is.Empty);
    }

    [Test]
    public async Task Receive_SlowDescriptionListener_DoesNotDelaySamples()
    {
        using var going = new SemaphoreSlim(0);
        _listener.Describing = _ => going.Wait(Soon.Limit);
        var socket = await _server.AcceptAsync();

        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, "first"));
        await Soon.BecomesAsync(() => _listener.Descriptions.Count == 1, "the first");
        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, "second"));
        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, "third"));
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _listener.Messages.Count == 1, "the message behind them");
        Assert.That(_listener.Descriptions, Is.EqualTo(new[] { "first" }));
        going.Release(3);
        await Soon.BecomesAsync(() => _listener.Descriptions.Count == 2, "the newest");
        Assert.That(_listener.Descriptions, Is.EqualTo(new[] { "first", "third" }));
    }

    [Test]
    public async Task Receive_DescriptionListenerThrows_IsCountedAndTheNextIsPassedOn()
    {
        _listener.Describing = urdf => { if (urdf == "bad") throw new InvalidOperationException("no description today"); };
        var socket = await _server.AcceptAsync();

        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, "bad"));
        await Soon.BecomesAsync(() => _listener.Drops.Count == 1, "the drop");
        await Send(socket, RosbridgeWriter.PublishString(RosTopics.RobotDescription, "good"));

        await Soon.BecomesAsync(() => _listener.Descriptions.Contains("good"), "the next");
        Assert.That(_listener.Drops, Is.EqualTo(new[] { DropReason.NotUrdf }));
    }

    [Test]
    public async Task Connect_WithDisplayedJoints_AdvertisesAndPublishesThem()
    {
        _listener.Displays.Enqueue(new JointStateMessage(ControlTime.FromSeconds(5), ["a"], [0.5], frameId: "left door"));
        var socket = await _server.AcceptAsync();

        Assert.That(await NextAsync(socket, "advertise", RosTopics.Diagnostics), Does.Contain(RosTopics.DiagnosticsType));
        Assert.That(await NextAsync(socket, "advertise", RosTopics.Displayed), Does.Contain(RosTopics.JointStateType));
        Assert.That(RosbridgeReader.TryRead(await NextAsync(socket, "publish", RosTopics.Displayed), out var message, out _), Is.True);
        Assert.That(message.Displayed.FrameId, Is.EqualTo("left door"));
        Assert.That(message.Displayed.Positions, Is.EqualTo(new[] { 0.5 }));
        Assert.That(message.JointState, Is.Null, "it is not a sample of the robot");
    }

    [Test]
    public async Task Connect_PublishingDisplayedOff_NeitherAdvertisesNorRequestsThem()
    {
        using var server = new FakeWebSocketServer();
        var clock = new StopwatchHeadsetClock();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: server.Port, publishesDisplayed: false);
        _listener.Displays.Enqueue(new JointStateMessage(ControlTime.FromSeconds(5), ["a"], [0.5], frameId: "left door"));
        _listener.Report = new DiagnosticsMessage(default, "left door", []);
        using var client = new RosbridgeClient(
            () => WebSocketLinks.Create(settings, clock), clock, _listener, settings.PublishesDisplayed);
        var socket = await server.AcceptAsync();

        var sent = new List<string>();
        while (!sent.Any(text => text.Contains("\"publish\""))) sent.Add(await ReceiveAsync(socket));

        Assert.That(sent, Has.None.Contains(RosTopics.Displayed));
        Assert.That(_listener.Displays, Has.Count.EqualTo(1));
    }

    static async Task<string> NextAsync(WebSocket socket, string op, string topic)
    {
        while (true)
        {
            var text = await ReceiveAsync(socket);
            if (text.Contains($"\"{op}\"") && text.Contains($"\"{topic}\"")) return text;
        }
    }

    static async Task<string> ReceiveAsync(WebSocket socket)
    {
        var buffer = new byte[4096];
        return Encoding.UTF8.GetString(buffer, 0, (await socket.ReceiveAsync(buffer, CancellationToken.None).Bounded()).Count);
    }

    [Test]
    public async Task Dispose_WhileConnected_EndsImmediately()
    {
        await _server.AcceptAsync();

        _client.Dispose();

        Assert.That(_client.Status.State, Is.EqualTo(LinkState.Idle));
        await _client.Ended.Bounded();
    }

    [Test]
    public async Task Dispose_ThreadIsBlocked_DoesNotWait()
    {
        await _server.AcceptAsync();
        var clock = new StuckClock();
        var settings = new ConnectionSettings("127.0.0.1", webSocketPort: _server.Port);
        var client = new RosbridgeClient(() => WebSocketLinks.Create(settings, clock), clock, _listener);
        await _server.AcceptAsync();
        await clock.Asked.Bounded();

        client.Dispose();

        Assert.That(client.Ended.IsCompleted, Is.False);
        clock.GoOn();
        await client.Ended.Bounded();
    }

    sealed class Listener : IRosbridgeListener
    {
        public ConcurrentQueue<JointStateMessage> Messages { get; } = [];
        public ConcurrentQueue<DropReason> Drops { get; } = [];
        public ConcurrentQueue<string> Descriptions { get; } = [];

        public ConcurrentQueue<JointTrajectoryMessage> Plans { get; } = [];

        public void Received(JointStateMessage message, HeadsetTime arrival) => Messages.Enqueue(message);

        public void Planned(JointTrajectoryMessage message, HeadsetTime arrival) => Plans.Enqueue(message);

        public ConcurrentQueue<JointStatusMessage> Statuses { get; } = [];

        public void StatusReceived(JointStatusMessage message, HeadsetTime arrival) => Statuses.Enqueue(message);

        public void Described(string urdf)
        {
            Descriptions.Enqueue(urdf);
            Describing?.Invoke(urdf);
        }

        public void Dropped(DropReason reason) => Drops.Enqueue(reason);
        public Action<string> Describing { get; set; }
        public bool FailDiagnostics { get; set; }

        public ConcurrentQueue<JointStateMessage> Displays { get; } = [];
        public JointStateMessage Displayed() => Displays.TryDequeue(out var shown) ? shown : null;

        public DiagnosticsMessage Report { get; set; }

        public DiagnosticsMessage Diagnostics() => FailDiagnostics ? throw new InvalidOperationException("no diagnostics today") : Report;
    }
}
