using System.Diagnostics;
using System.Text;
using NUnit.Framework;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Headless.Tests.Gateway;

public class SubscriptionTests
{
    [Test]
    public async Task Dispose_DuringALongThrottle_EndsThePump()
    {
        var hub = new MessageHub();
        using var source = hub.OpenSource();
        var subscription = new Subscription(
            hub, RosTopics.JointStates, new SubscriptionTerms(RosTimeForm.Sec, int.MaxValue, 0), 16, new DropCounters());
        var sent = new TaskCompletionSource();
        var pump = subscription.PumpAsync(
            next =>
            {
                next(long.MinValue);
                sent.TrySetResult();
                return Task.CompletedTask;
            },
            CancellationToken.None);
        source.Publish(new JointStateMessage(ControlTime.FromSeconds(1), ["a"], [0.5]));
        await sent.Task.Bounded();

        subscription.Dispose();

        await pump.Bounded();
    }

    [TestCase(true, 9)]
    [TestCase(false, 0)]
    public async Task Pump_MessagesQueued_SkipsToTheNewestOnlyForASlowReader(bool isReaderSlow, int dropped)
    {
        var hub = new MessageHub();
        using var source = hub.OpenSource();
        var drops = new DropCounters();
        using var subscription = new Subscription(hub, RosTopics.JointStates, default, 16, drops);
        var old = Stopwatch.GetTimestamp() - Stopwatch.Frequency;
        for (var i = 0; i < 10; i++)
            source.Publish(new JointStateMessage(ControlTime.FromSeconds(i + 1), ["a"], [i]), old);
        var sent = new TaskCompletionSource<string>();

        _ = subscription.PumpAsync(
            next =>
            {
                sent.TrySetResult(Encoding.UTF8.GetString(next(isReaderSlow ? Stopwatch.GetTimestamp() : long.MinValue).Span));
                return Task.CompletedTask;
            },
            CancellationToken.None);

        Assert.That(RosbridgeReader.TryRead(await sent.Task.Bounded(), out var message, out _), Is.True);
        Assert.That(message.JointState.Positions[0], Is.EqualTo(dropped));
        Assert.That(drops[DropReason.SlowReader], Is.EqualTo(dropped));
    }

    // Many sources publish one message per object, all at the same time.
    [Test]
    public async Task Pump_OneMessagePerObjectOfTheLargestCell_SendsAll()
    {
        var hub = new MessageHub();
        using var source = hub.OpenSource();
        var drops = new DropCounters();
        using var subscription = new Subscription(hub, RosTopics.Tf, default, 16, drops);
        for (var i = 0; i < ProtocolLimits.Frames; i++)
            source.Publish(new TransformsMessage(new FrameTransform(ControlTime.FromSeconds(1), "world", "object" + i, 0, 0, 0, 0, 0, 0, 1)), false, []);
        var (sent, isDone) = (0, new TaskCompletionSource());

        _ = subscription.PumpAsync(
            next =>
            {
                if (!next(long.MinValue).IsEmpty) sent++;
                if (sent == ProtocolLimits.Frames) isDone.TrySetResult();
                return Task.CompletedTask;
            },
            CancellationToken.None);

        await isDone.Task.Bounded();
        Assert.That(drops[DropReason.SlowReader], Is.Zero);
    }

    static void Publish(HubSource source, string child, double x, bool isStationary) => source.Publish(
        new TransformsMessage(new FrameTransform(ControlTime.FromSeconds(1), "world", child, x, 0, 0, 0, 0, 0, 1)), isStationary, []);

    // Publishes poses of the frame "moved" while the client does not read, and then lets the client read. Returns the positions that it receives on
    // one topic.
    static async Task<double[]> ReceivedAsync(string topic, params (double X, bool IsStationary)[] published)
    {
        var hub = new MessageHub();
        using var source = hub.OpenSource();
        using var subscription = new Subscription(hub, topic, default, 16, new DropCounters());
        var (received, reads, began, ends) = (new List<double>(), new TaskCompletionSource(), new TaskCompletionSource(), new TaskCompletionSource());
        Publish(source, "first", 0, topic == RosTopics.TfStatic);
        _ = subscription.PumpAsync(
            async next =>
            {
                if (began.Task.IsCompleted) await reads.Task;
                if (!RosbridgeReader.TryRead(Encoding.UTF8.GetString(next(long.MinValue).Span), out var message, out _)) return;
                for (var i = 0; i < message.Transforms.Count; i++)
                {
                    if (message.Transforms[i].Child == "first") began.TrySetResult();
                    else if (message.Transforms[i].Child == "last") ends.TrySetResult();
                    else received.Add(message.Transforms[i].X);
                }
            },
            CancellationToken.None);
        await began.Task.Bounded();

        foreach (var (x, isStationary) in published) Publish(source, "moved", x, isStationary);
        Publish(source, "last", 0, topic == RosTopics.TfStatic);
        reads.SetResult();

        await ends.Task.Bounded();
        return [.. received];
    }

    // The topics have separate queues, so the stationary pose may have been sent already.
    [Test]
    public async Task Pump_FrameHasBecomeStationary_LeavesOutItsEarlierMovingPose() =>
        Assert.That(await ReceivedAsync(RosTopics.Tf, (1, false), (2, true)), Is.Empty);

    [Test]
    public async Task Pump_FrameIsNoLongerStationary_LeavesOutItsStationaryPose() =>
        Assert.That(await ReceivedAsync(RosTopics.TfStatic, (1, true), (2, false)), Is.Empty);

    [TestCase(RosTopics.Tf, new[] { 2.0, 3.0 })]
    [TestCase(RosTopics.TfStatic, new double[0])]
    public async Task Pump_FrameMovesAfterItsStationaryPose_SendsItsMovingPoses(string topic, double[] expected) =>
        Assert.That(await ReceivedAsync(topic, (1, true), (2, false), (3, false)), Is.EqualTo(expected).AsCollection);
}
