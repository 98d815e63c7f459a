using System.Diagnostics;
using System.Text;
using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Rosbridge;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Cell;

/// <summary>Tests which messages a slow subscriber to a latched topic receives.</summary>
[FixtureLifeCycle(LifeCycle.InstancePerTestCase)]
public class LatchedQueueTests
{
    readonly MessageHub _hub = new();
    readonly DropCounters _drops = new();

    void Publish(HubSource source, string name, double value, long? receivedAt = null) => Assert.That(
        source.Publish(new SignalsMessage(Gateways.Start, new SignalValue(name, value)), [], receivedAt), Is.True);

    static string TextOf(ReadOnlyMemory<byte> utf8) =>
        !utf8.IsEmpty && RosbridgeReader.TryRead(Encoding.UTF8.GetString(utf8.Span), out var message, out _) ? message.Signals.Text() : null;

    // Lets the subscription send messages until it has sent the message `last`. Returns all sent messages as text.
    static async Task<List<string>> SentAsync(Subscription subscription, string last, bool isReaderSlow)
    {
        var sent = new List<string>();
        var isDone = new TaskCompletionSource();
        _ = subscription.PumpAsync(
            next =>
            {
                if (TextOf(next(isReaderSlow ? Stopwatch.GetTimestamp() : long.MinValue)) is { } text) sent.Add(text);
                if (sent.Contains(last)) isDone.TrySetResult();
                return Task.CompletedTask;
            },
            CancellationToken.None);
        await isDone.Task.Bounded();
        subscription.Dispose();
        return sent;
    }

    [Test]
    public async Task Pump_QueueOverflows_SendsTheNewestOfEachName()
    {
        using var source = _hub.OpenSource();
        using var subscription = new Subscription(_hub, RosTopics.Signals, default, 4, _drops);
        Publish(source, "grip", 1);
        for (var i = 1; i <= 20; i++) Publish(source, "s" + i % 3, i);

        var sent = await SentAsync(subscription, "s2=20", isReaderSlow: false);

        Assert.That(sent, Is.EqualTo(new[] { "grip=1", "s0=18", "s1=19", "s2=20" }));
    }

    [Test]
    public async Task Pump_MessagesWaitForASlowClient_SendsTheNewestOfEachName()
    {
        using var source = _hub.OpenSource();
        using var subscription = new Subscription(_hub, RosTopics.Signals, default, 16, _drops);
        var old = Stopwatch.GetTimestamp() - Stopwatch.Frequency;
        Publish(source, "grip", 1, old);
        for (var i = 1; i <= 9; i++) Publish(source, "s", i, old);

        var sent = await SentAsync(subscription, "s=9", isReaderSlow: true);

        Assert.That(sent, Is.EqualTo(new[] { "grip=1", "s=9" }));
        Assert.That(_drops[DropReason.SlowReader], Is.EqualTo(8));
    }

    [TestCase("1 0 1", "0 1")]
    [TestCase("0 1 0 1 1", "0 1")]
    [TestCase("1 1", "1")]
    [TestCase("0", "0")]
    public void Next_ValuesWaitedForASlowClient_ReturnsTheNewestAndTheDifferentValueBefore(string waiting, string expected)
    {
        using var source = _hub.OpenSource();
        var (queue, queued) = NewQueue();
        using var subscription = _hub.SubscribeToNew(RosTopics.Signals, message => queued.Writer.TryWrite(message));
        Publish(source, "lamp", 1);
        Publish(source, "grip", 0);
        Publish(source, "grip", 1);
        Assert.That(Received(queue, _ => false), Is.EqualTo(new[] { "lamp=1", "grip=1" }), "a new client receives only current values");
        var old = Stopwatch.GetTimestamp() - Stopwatch.Frequency;

        foreach (var value in waiting.Split(' ')) Publish(source, "grip", int.Parse(value), old);

        Assert.That(Received(queue, receivedAt => receivedAt <= old), Is.EqualTo(expected.Split(' ').Select(value => "grip=" + value)));
    }

    [TestCase("", "door=1 grip=1")]
    [TestCase("0 1", "door=1 grip=0 grip=1")]
    public void Next_CurrentValuesWaitForANewSlowClient_ReturnsNoEarlierValue(string publishedLater, string expected)
    {
        using var source = _hub.OpenSource();
        var (queue, queued) = NewQueue();
        using var subscription = _hub.SubscribeToNew(RosTopics.Signals, message => queued.Writer.TryWrite(message));
        foreach (var (name, value) in new[] { ("lamp", 1), ("door", 1), ("grip", 0), ("grip", 1) }) Publish(source, name, value);
        Assert.That(((SignalsMessage)queue.Next(_ => false).Content).Text(), Is.EqualTo("lamp=1"));

        foreach (var value in publishedLater.Split(' ', StringSplitOptions.RemoveEmptyEntries)) Publish(source, "grip", int.Parse(value));

        var checks = 0;
        Assert.That(Received(queue, _ => checks++ == 0), Is.EqualTo(expected.Split(' ')));
    }

    // The queue reports a dropped message after it has released its lock, so the client may receive the next message before.
    [Test]
    public void Next_DropIsReportedAfterANewerMessage_ReturnsNoOlderValue()
    {
        using var source = _hub.OpenSource();
        var (queue, queued) = NewQueue();
        using var subscription = _hub.SubscribeToNew(RosTopics.Signals, message => queued.Writer.TryWrite(message));
        Publish(source, "grip", 1);
        Assert.That(Received(queue, _ => false), Is.EqualTo(new[] { "grip=1" }));
        Publish(source, "lamp", 1);
        Publish(source, "grip", 0);
        Publish(source, "grip", 1);
        HubMessage[] dropped = [Read(), Read()];
        Assert.That(((SignalsMessage)queue.Next(_ => false).Content).Text(), Is.EqualTo("grip=1"));

        foreach (var message in dropped) queue.Lose(message);

        Assert.That(Received(queue, _ => false), Is.EqualTo(new[] { "lamp=1" }));

        HubMessage Read() => queued.Reader.TryRead(out var message) ? message : null;
    }

    [Test]
    public void IsNextTogether_ValuesChangeBeforeEachReadingOfASlowThrottledClient_IsFalseAfterOneValuePerSignal()
    {
        using var source = _hub.OpenSource();
        var (queue, queued) = NewQueue(isThrottled: true);
        using var subscription = _hub.SubscribeToNew(RosTopics.Signals, message => queued.Writer.TryWrite(message));
        var returned = 0;

        do
        {
            foreach (var name in new[] { "a", "b", "c" }) Publish(source, name, returned);
            Assert.That(queue.Next(_ => true), Is.Not.Null);
        }
        while (++returned < 20 && queue.IsNextTogether);

        Assert.That(returned, Is.EqualTo(3));
    }

    // A queue of a new subscription, with the channel from which it reads.
    (LatchedQueue Queue, Channel<HubMessage> Queued) NewQueue(bool isThrottled = false)
    {
        var queued = Channel.CreateUnbounded<HubMessage>();
        var queue = new LatchedQueue(_hub, RosTopics.Signals, queued, isThrottled, () => { });
        queue.Start();
        return (queue, queued);
    }

    static string[] Received(LatchedQueue queue, Func<long, bool> isOld)
    {
        var received = new List<string>();
        while (queue.Next(isOld) is { } message) received.Add(((SignalsMessage)message.Content).Text());
        return [.. received];
    }

    [TestCase(0, "s=1 s=4")]
    [TestCase(1, "s=1 s=4")]
    [TestCase(3, "s=1 s=2 s=3 s=4")]
    public async Task Pump_SignalChangesSeveralTimesInAThrottleInterval_SendsItsNewestValueOnceOrTheQueue(int queueLength, string expected)
    {
        using var source = _hub.OpenSource();
        using var subscription = new Subscription(_hub, RosTopics.Signals, new SubscriptionTerms(RosTimeForm.Sec, ThrottleMs: 1, queueLength), 16, _drops);
        Publish(source, "s", 1);
        var (sent, isDone) = (new List<string>(), new TaskCompletionSource());

        _ = subscription.PumpAsync(
            next =>
            {
                if (TextOf(next(long.MinValue)) is not { } text) return Task.CompletedTask;
                sent.Add(text);
                for (var i = 2; sent.Count == 1 && i <= 4; i++) Publish(source, "s", i);
                if (text == "s=4") isDone.TrySetResult();
                return Task.CompletedTask;
            },
            CancellationToken.None);
        await isDone.Task.Bounded();

        Assert.That(sent, Is.EqualTo(expected.Split(' ')));
    }

    // The pump returns at its first pause, because nothing else in this test waits.
    [Test]
    public void Pump_SignalsChangeDuringEachSendToAThrottledClient_PausesAfterOneValuePerSignal()
    {
        using var source = _hub.OpenSource();
        using var subscription = new Subscription(
            _hub, RosTopics.Signals, new SubscriptionTerms(RosTimeForm.Sec, ThrottleMs: int.MaxValue, QueueLength: 0), 16, _drops);
        var sent = new List<string>();
        PublishBoth();

        _ = subscription.PumpAsync(
            next =>
            {
                if (TextOf(next(long.MinValue)) is { } text) sent.Add(text);
                if (sent.Count == 20) subscription.Dispose();
                PublishBoth();
                return Task.CompletedTask;
            },
            CancellationToken.None);

        Assert.That(sent, Is.EqualTo(new[] { "a=0", "b=0" }));

        void PublishBoth()
        {
            Publish(source, "a", sent.Count);
            Publish(source, "b", sent.Count);
        }
    }

    [Test]
    public async Task Pump_ClientReadsFast_SendsEachChangeInOrder()
    {
        using var source = _hub.OpenSource();
        using var subscription = new Subscription(_hub, RosTopics.Signals, default, 16, _drops);
        var sending = SentAsync(subscription, "t=9", isReaderSlow: false);

        for (var i = 1; i <= 9; i++)
        {
            Publish(source, "s", i);
            Publish(source, "t", i);
        }

        var sent = await sending;

        Assert.That(sent[^1], Is.EqualTo("t=9"));
        foreach (var name in "st")
        {
            var values = sent.Where(text => text[0] == name).Select(text => int.Parse(text[2..])).ToList();
            Assert.That(values, Is.Ordered);
            Assert.That(values[^1], Is.EqualTo(9));
        }
    }

    [Test]
    public async Task Pump_MessageWithSeveralNames_SendsTheCurrentValues()
    {
        using var source = _hub.OpenSource();
        source.Publish(new SignalsMessage(Gateways.Start, new SignalValue("a", 1), new SignalValue("b", 1), new SignalValue("c", 1)), []);
        Publish(source, "b", 2);
        using var subscription = new Subscription(_hub, RosTopics.Signals, default, 16, _drops);

        var sent = await SentAsync(subscription, "b=2", isReaderSlow: false);

        Assert.That(sent, Is.EqualTo(new[] { "a=1 c=1", "b=2" }));
    }

    [Test]
    public async Task Dispose_ValuesWaiting_EndsThePump()
    {
        using var source = _hub.OpenSource();
        for (var i = 0; i < 100; i++) Publish(source, "s" + i, i);
        var subscription = new Subscription(_hub, RosTopics.Signals, default, 16, _drops);
        var sent = 0;

        await subscription.PumpAsync(
            next =>
            {
                if (!next(long.MinValue).IsEmpty && ++sent == 5) subscription.Dispose();
                return Task.CompletedTask;
            },
            CancellationToken.None).Bounded();

        Assert.That(sent, Is.EqualTo(5));
    }

    [Test]
    public void MessageParts_LongNames_AreSplitWithinTheLimit()
    {
        // The limit allows for six characters per escaped character. An escaped backslash has only two.
        var names = Enumerable.Range(0, 256).Select(i => new string('\\', 124) + i.ToString("000")).ToArray();
        var signals = new SignalsMessage(Gateways.Start, [.. names.Select(name => new SignalValue(name, -1.0 / 3e-300))]);
        var frames = new TransformsMessage([.. names.Select(name => CellTexts.Frame(name, "world", -1.0 / 3e-300))]);

        var parts = MessageParts.Of(signals).ToList();
        var frameParts = MessageParts.Of(frames).ToList();

        Assert.That(parts.Sum(part => part.Count), Is.EqualTo(256));
        Assert.That(frameParts.Sum(part => part.Count), Is.EqualTo(256));
        Assert.That(parts, Has.Count.GreaterThan(1));
        foreach (var part in parts)
            Assert.That(
                Encoding.UTF8.GetByteCount(RosbridgeWriter.Publish(RosTopics.Signals, part, RosTimeForm.Secs)),
                Is.LessThanOrEqualTo(ProtocolLimits.MessageBytes));
        foreach (var part in frameParts)
            Assert.That(
                Encoding.UTF8.GetByteCount(RosbridgeWriter.Publish(RosTopics.TfStatic, part, RosTimeForm.Secs)),
                Is.LessThanOrEqualTo(ProtocolLimits.MessageBytes));
    }
}
