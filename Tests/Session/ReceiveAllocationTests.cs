using System.Net.WebSockets;
using System.Text;
using Nowpose.Gateway.Plants;
using Nowpose.Headless.Tests.Network;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Prediction;
using Nowpose.Protocol;
using Nowpose.Session;
using Nowpose.Sync;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Session;

/// <summary>Tests the allocations of a sample on its complete path: from the socket through reader, queue and frame to the predictors.</summary>
[NonParallelizable] // measures allocations
public class ReceiveAllocationTests
{
    const int Warm = 500, Messages = 2000;
    const int AllowedBytes = 200;

    [TestCase("quadratic", false, "")]
    [TestCase("adaptive", false, "")]
    [TestCase("quadratic", true, "")]
    [TestCase("quadratic", false, "gripper")]
    [TestCase("quadratic", false, "body first")]
    public async Task Receive_SevenJointsRepeatedly_AllocatesAlmostNothing(string predictor, bool hasVelocities, string source)
    {
        var robot = RobotFiles.Load("youbot");
        var names = robot.MovingJoints.Select(joint => joint.Name).Take(7).ToArray();
        Assert.That(names, Has.Length.EqualTo(7));
        using var session = new CompensationSession(
            new SessionSettings(
                new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40)), new PredictionSettings(predictor)),
            robot, new StopwatchHeadsetClock());
        var clock = new ManualClock();
        var texts = Enumerable.Range(0, Warm + Messages).Select(i => Encoding.UTF8.GetBytes(Text(i, names, hasVelocities, source))).ToArray();
        var (before, after) = (0L, 0L);
        var socket = new MemoryWebSocket(texts, i =>
        {
            // Runs the frame on the receiving thread, so that its allocations are counted, too.
            clock.Now = At(i);
            if (i % 20 == 0) Synchronise(session, clock.Now);
            if (i > 0) session.Tick(clock.Now);
            if (i == Warm) before = GC.GetAllocatedBytesForCurrentThread();
            if (i == texts.Length) after = GC.GetAllocatedBytesForCurrentThread();
        });
        using var client = new RosbridgeClient(() => new SystemWebSocketLink(_ => Task.FromResult<WebSocket>(socket), clock), clock, session.Listener, Subscribed.ToRobot(), publishesDisplayed: false);

        await socket.Ended.Bounded();

        var statistics = session.Statistics(clock.Now);
        Assert.That(statistics.Samples, Is.EqualTo(texts.Length));
        Assert.That(statistics.Dropped, Is.Zero);
        TestContext.Out.WriteLine($"{(after - before) / (double)Messages} B per message");
        Assert.That((after - before) / (double)Messages, Is.LessThanOrEqualTo(AllowedBytes));
    }

    [Test]
    public async Task Receive_HandlerKeepsMessages_DoesNotReuseThem()
    {
        var robot = RobotFiles.Load("youbot");
        var names = robot.MovingJoints.Select(joint => joint.Name).Take(7).ToArray();
        using var session = new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), new VisualisationLatency(TimeSpan.FromMilliseconds(40))), robot,
            new StopwatchHeadsetClock());
        var clock = new ManualClock();
        var kept = new List<Arrival<JointStateMessage>>();
        session.Intake.SampleTaken += (arrival, _) => kept.Add(arrival);
        var texts = Enumerable.Range(0, 100).Select(i => Encoding.UTF8.GetBytes(Text(i, names, false, ""))).ToArray();
        var socket = new MemoryWebSocket(texts, i =>
        {
            clock.Now = At(i);
            if (i == 0) Synchronise(session, clock.Now);
            session.Tick(clock.Now);
        });
        using var client = new RosbridgeClient(() => new SystemWebSocketLink(_ => Task.FromResult<WebSocket>(socket), clock), clock, session.Listener, Subscribed.ToRobot(), publishesDisplayed: false);

        await socket.Ended.Bounded();

        Assert.That(kept.Select(arrival => arrival.Message.Positions[0]), Is.EqualTo(Enumerable.Range(0, 100).Select(i => Position(i, 0))));
    }

    static HeadsetTime At(int message) => HeadsetTime.FromSeconds(10 + message * 0.01);

    static void Synchronise(CompensationSession session, HeadsetTime now)
    {
        var control = new ControlTime(now.SinceEpoch);
        session.Clock.Add(new SyncExchange(now - TimeSpan.FromMilliseconds(2), control, control, now), out _);
    }

    static double Position(int message, int joint) => 0.5 * Math.Sin(message * 0.01 + joint);

    static string Text(int message, string[] names, bool hasVelocities, string source)
    {
        var joints = source == "gripper" && message % 2 == 1 ? names[5..] : names;
        var stamp = new ControlTime(At(message).SinceEpoch) - TimeSpan.FromMilliseconds(30);
        var positions = joints.Select((_, joint) => Position(message, joint)).ToArray();
        var text = RosbridgeWriter.Publish(
            RosTopics.JointStates, new JointStateMessage(stamp, joints, positions, hasVelocities ? positions : null), RosTimeForm.Sec);
        const string head = "\"op\":\"publish\",\"topic\":\"/joint_states\"";
        return source == "body first" ? text.Replace(head + ",", "")[..^1] + "," + head + "}" : text;
    }

    sealed class ManualClock : IHeadsetClock
    {
        public HeadsetTime Now { get; set; } = At(0);
    }

    /// <summary>A socket that returns the given messages from memory, one per receive call. After the last one, it receives nothing.</summary>
    sealed class MemoryWebSocket(byte[][] messages, Action<int> beforeMessage) : WebSocket
    {
        readonly TaskCompletionSource _ended = new(TaskCreationOptions.RunContinuationsAsynchronously);
        readonly TaskCompletionSource<ValueWebSocketReceiveResult> _never = new();
        int _next;

        public Task Ended => _ended.Task;
        public override WebSocketCloseStatus? CloseStatus => null;
        public override string CloseStatusDescription => null;
        public override WebSocketState State => WebSocketState.Closed;
        public override string SubProtocol => null;

        public override ValueTask<ValueWebSocketReceiveResult> ReceiveAsync(Memory<byte> buffer, CancellationToken cancellationToken)
        {
            if (_next <= messages.Length)
            {
                try
                {
                    beforeMessage(_next);
                }
                catch (Exception e)
                {
                    _ended.TrySetException(e);
                }
            }
            if (_next++ >= messages.Length)
            {
                _ended.TrySetResult();
                return new ValueTask<ValueWebSocketReceiveResult>(_never.Task);
            }
            messages[_next - 1].CopyTo(buffer);
            return new ValueTask<ValueWebSocketReceiveResult>(
                new ValueWebSocketReceiveResult(messages[_next - 1].Length, WebSocketMessageType.Text, true));
        }

        public override Task<WebSocketReceiveResult> ReceiveAsync(ArraySegment<byte> buffer, CancellationToken cancellationToken) =>
            throw new NotSupportedException();

        public override Task SendAsync(
            ArraySegment<byte> buffer, WebSocketMessageType messageType, bool endOfMessage, CancellationToken cancellationToken) =>
            Task.CompletedTask;

        public override Task CloseAsync(WebSocketCloseStatus closeStatus, string statusDescription, CancellationToken cancellationToken) =>
            Task.CompletedTask;

        public override Task CloseOutputAsync(WebSocketCloseStatus closeStatus, string statusDescription, CancellationToken cancellationToken) =>
            Task.CompletedTask;

        public override void Abort() => _never.TrySetCanceled();
        public override void Dispose() => _never.TrySetCanceled();
    }
}
