using System.Diagnostics;
using System.Globalization;
using System.Text;
using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests that a client receives the newest sample of each joint and frame whose source sends a sample only when the value changes.</summary>
public class SampleQueueTests
{
    MessageHub _hub;
    HubSource _source;
    Channel<string> _received;
    Subscription _subscription;

    [SetUp]
    public void Open()
    {
        _hub = new MessageHub();
        _source = _hub.OpenSource();
        _received = Channel.CreateUnbounded<string>();
    }

    [TearDown]
    public void Close()
    {
        _subscription?.Dispose();
        _source.Dispose();
    }

    static long Ago(double seconds) => Stopwatch.GetTimestamp() - (long)(seconds * Stopwatch.Frequency);

    // A joint whose newest sample is from the future is not at rest, however slow the test runs.
    static long Fresh => Ago(-3600);

    static JointStateMessage State(double stamp, params string[] joints) => new(ControlTime.FromSeconds(stamp), joints, new double[joints.Length]);

    void Publish(double stamp, long receivedAt, params string[] joints) => _source.Publish(State(stamp, joints), receivedAt);

    void PublishPose(double stamp, long receivedAt, string frame) => _source.Publish(
        new TransformsMessage(new FrameTransform(ControlTime.FromSeconds(stamp), "world", frame, 0, 0, 0, 0, 0, 0, 1)), false, [], receivedAt);

    void Subscribe(string topic = RosTopics.JointStates, SubscriptionTerms terms = default) =>
        _subscription = new Subscription(_hub, topic, terms, 16, new DropCounters());

    // Starts to read the messages of the subscription.
    void Read(bool isSlow = false) => _ = _subscription.PumpAsync(
        next =>
        {
            var text = Encoding.UTF8.GetString(next(isSlow ? Stopwatch.GetTimestamp() : long.MinValue).Span);
            if (RosbridgeReader.TryRead(text, out var message, out _)) _received.Writer.TryWrite(TextOf(message));
            return Task.CompletedTask;
        },
        CancellationToken.None);

    // Joints or frames of a message, and its stamp in seconds.
    static string TextOf(RosbridgeMessage message)
    {
        var (names, stamp) = message.JointState is { } state
            ? (string.Join('+', state.Names), state.Stamp) : (message.Transforms[0].Child, message.Transforms[0].Stamp);
        return string.Create(CultureInfo.InvariantCulture, $"{names} {stamp.SinceEpoch.TotalSeconds:0}");
    }

    async Task<string[]> NextAsync(int count)
    {
        var received = new string[count];
        for (var i = 0; i < count; i++) received[i] = await _received.Reader.ReadAsync().AsTask().Bounded();
        return received;
    }

    // The second time, the joint comes to rest only after the subscription.
    [TestCase(3600)]
    [TestCase(0.9)]
    public async Task Subscribe_JointAtRest_ReceivesItsNewestSampleWithItsStamp(double secondsAgo)
    {
        Publish(1, Ago(secondsAgo + 1), "finger");
        Publish(2, Ago(secondsAgo), "finger");
        Subscribe();

        Read();

        Assert.That(await NextAsync(1), Is.EqualTo(new[] { "finger 2" }));
        Publish(3, Fresh, "finger");
        Assert.That(await NextAsync(1), Is.EqualTo(new[] { "finger 3" }), "each sample arrives once");
    }

    [Test]
    public async Task Subscribe_JointMoves_ReceivesOnlyLaterSamples()
    {
        Publish(1, Fresh, "arm");
        Subscribe();
        Read();

        Publish(2, Fresh, "arm");
        Publish(3, Fresh, "arm");

        Assert.That(await NextAsync(2), Is.EqualTo(new[] { "arm 2", "arm 3" }));
    }

    [Test]
    public async Task Subscribe_OnlyOneJointOfASampleAtRest_ReceivesThisJoint()
    {
        Publish(1, Ago(10), "arm", "finger");
        Publish(2, Fresh, "arm");
        Subscribe();
        Read();

        Assert.That(await NextAsync(1), Is.EqualTo(new[] { "finger 1" }));
        Publish(3, Fresh, "arm");
        Assert.That(await NextAsync(1), Is.EqualTo(new[] { "arm 3" }));
    }

    [Test]
    public async Task Subscribe_SourceOfTheJointHasEnded_ReceivesNoSample([Values] bool isReleased)
    {
        using var other = _hub.OpenSource();
        Publish(1, Ago(10), "finger");
        if (isReleased) _source.Release(RosTopics.JointStates);
        else _source.Dispose();
        Subscribe();
        Read();

        other.Publish(State(2, "finger"));

        Assert.That(await NextAsync(1), Is.EqualTo(new[] { "finger 2" }));
    }

    [Test]
    public async Task Subscribe_RobotWithANamespace_ReceivesOnlyItsJoints()
    {
        Publish(1, Ago(10), "finger");
        _source.Publish(State(2, "finger"), Ago(10), "arm1");
        Subscribe("/arm1/joint_states");
        Read();

        _source.Publish(State(3, "arm"), Fresh, "arm1");

        Assert.That(await NextAsync(2), Is.EqualTo(new[] { "finger 2", "arm 3" }));
    }

    [TestCase(RosTopics.JointStates)]
    [TestCase(RosTopics.Tf)]
    public async Task Pump_SlowReader_ReceivesTheNewestSampleOfEachJointOrFrame(string topic)
    {
        Subscribe(topic);
        foreach (var (name, stamp) in new[] { ("arm", 1), ("finger", 2), ("finger", 3), ("arm", 4), ("arm", 5), ("arm", 6) })
        {
            if (topic == RosTopics.Tf) PublishPose(stamp, Ago(1 - 0.01 * stamp), name);
            else Publish(stamp, Ago(1 - 0.01 * stamp), name);
        }

        Read(isSlow: true);

        Assert.That(await NextAsync(2), Is.EqualTo(new[] { "finger 3", "arm 6" }));
    }

    [TestCase(RosTopics.JointStates)]
    [TestCase(RosTopics.Tf)]
    public async Task Pump_QueueFull_SendsTheNewestSampleOfEachJointOrFrame(string topic)
    {
        Subscribe(topic, new SubscriptionTerms(RosTimeForm.Sec, 0, 2));
        foreach (var (name, stamp) in new[] { ("finger", 1), ("arm", 2), ("arm", 3), ("arm", 4), ("arm", 5) })
        {
            if (topic == RosTopics.Tf) PublishPose(stamp, Ago(-stamp), name);
            else Publish(stamp, Ago(-stamp), name);
        }

        Read();

        Assert.That(await NextAsync(3), Is.EqualTo(new[] { "finger 1", "arm 4", "arm 5" }));
    }

    // The queue of a throttled subscription has room for one message.
    [Test]
    public async Task Pump_ThrottledSubscription_ReceivesTheNewestSampleOfAJointAtRestOnly()
    {
        Subscribe(terms: new SubscriptionTerms(RosTimeForm.Sec, 1, 0));
        Publish(1, Ago(2), "finger");
        Publish(2, Fresh, "rail");
        Publish(3, Fresh, "arm");
        Read();

        Assert.That(await NextAsync(2), Is.EqualTo(new[] { "finger 1", "arm 3" }));
        Publish(4, Fresh, "arm");
        Assert.That(await NextAsync(1), Is.EqualTo(new[] { "arm 4" }), "the rail moves, so that its next sample follows");
    }
}
