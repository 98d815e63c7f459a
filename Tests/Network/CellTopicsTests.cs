using System.Net.WebSockets;
using Nowpose.Gateway.Plants;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using Nowpose.Recording;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Network.PlayedServer;

namespace Nowpose.Headless.Tests.Network;

/// <summary>Tests the topics of several robots and of the cell's objects and signals on one connection.</summary>
public class CellTopicsTests
{
    PlayedServer _played;

    [SetUp]
    public void Start() => _played = new PlayedServer();

    [TearDown]
    public void Stop() => _played.Dispose();

    [Test]
    public async Task Subscribe_WhileConnected_SendsImmediatelyAndAfterReconnecting()
    {
        var socket = await _played.Server.AcceptAsync();
        await NextAsync(socket, RosTopics.JointStatus);

        _played.Subscriptions.AddRobot("arm2");
        _played.Subscriptions.AddRobot("arm2");

        await NextAsync(socket, "/arm2/robot_description");
        await socket.CloseOutputAsync(WebSocketCloseStatus.NormalClosure, "", CancellationToken.None);
        var second = await _played.Server.AcceptAsync();
        foreach (var topic in new[] { RosTopics.JointStates, RosTopics.JointStatus, "/arm2/joint_states", "/arm2/joint_trajectory" })
            await NextAsync(second, topic);
    }

    [Test]
    public async Task Receive_RobotInANamespace_IsDistinguishedFromOtherRobots()
    {
        var socket = await _played.Server.AcceptAsync();

        await Send(socket, Good.Replace("/joint_states", "/arm2/joint_states"));
        await Send(socket, Good);

        await Soon.BecomesAsync(() => _played.Listener.Messages.Count == 2, "two messages");
        Assert.That(_played.Listener.Robots, Is.EqualTo(new[] { "arm2", "" }));
    }

    [Test]
    public async Task Report_RobotWithoutSamples_RequestsTheNamespaces()
    {
        _played.Listener.NeedsNamespaces = true;
        var socket = await _played.Server.AcceptAsync();

        await NextAsync(socket, RosTopics.GetTopics, "call_service");
        var topic = KeyValuePair.Create("/arm2/joint_states", RosTopics.JointStateType);
        await Send(socket, RosbridgeWriter.TopicsResponse(RosTopics.GetTopics, null, [topic]));

        await Soon.BecomesAsync(() => !_played.Listener.Namespaces.IsEmpty, "the namespaces");
        Assert.That(_played.Listener.Namespaces.Single(), Is.EqualTo(new[] { "arm2" }));
    }

    [Test]
    public async Task Receive_FramesAndSignals_AreDistinguished()
    {
        var socket = await _played.Server.AcceptAsync();
        var pose = new FrameTransform(ControlTime.FromSeconds(5), "world", "box", 1, 2, 3, 0, 0, 0, 1);

        await Send(socket, RosbridgeWriter.Publish(RosTopics.Tf, new TransformsMessage(pose), RosTimeForm.Sec));
        await Send(socket, RosbridgeWriter.Publish(RosTopics.TfStatic, new TransformsMessage(pose), RosTimeForm.Sec));
        await Send(socket, RosbridgeWriter.Publish(
            RosTopics.Signals, new SignalsMessage(ControlTime.FromSeconds(5), new SignalValue("grip", 1)), RosTimeForm.Sec));

        await Soon.BecomesAsync(() => !_played.Listener.Signals.IsEmpty, "a signal");
        Assert.That(_played.Listener.Frames.Select(frame => frame.IsStationary), Is.EqualTo(new[] { false, true }));
        Assert.That(_played.Listener.Frames.First().Message[0].Child, Is.EqualTo("box"));
        Assert.That(_played.Listener.Signals.Single()[0].Value, Is.EqualTo(1));
    }

    [Test]
    public async Task Recording_SessionThatShowsNoSignal_SubscribesToSignals()
    {
        using var folder = new TemporaryFolder();
        using var server = new FakeWebSocketServer();
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1", webSocketPort: server.Port), default), RobotFiles.Load("youbot"),
            new StopwatchHeadsetClock());
        session.Connect();
        var socket = await server.AcceptAsync();
        await NextAsync(socket, RosTopics.JointStates);

        using var recorder = new SessionRecorder(session, new RecordingSettings(Path.Combine(folder.Path, "session.jsonl")));

        await NextAsync(socket, RosTopics.Signals);
    }

    static async Task NextAsync(WebSocket socket, string topic, string op = "subscribe")
    {
        string text;
        do text = await ReceiveAsync(socket);
        while (!text.Contains($"\"{op}\"") || !text.Contains($"\"{topic}\""));
    }
}
