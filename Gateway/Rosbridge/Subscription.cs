using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>A client's subscription to one topic: a queue that drops its oldest message when full, and the loop that sends from the queue.</summary>
sealed class Subscription : IDisposable
{
    internal const int MaxQueueLength = 1024;

    readonly MessageHub _hub;
    readonly Channel<HubMessage> _queue;
    readonly IDisposable _subscriber;
    readonly ForwardingTimes _times;
    readonly SubscriptionTerms _terms;
    readonly Action _lost;
    // One of the two is null.
    readonly LatchedQueue _latched;
    readonly SampleQueue _samples;
    // Continues the sending loop on the thread that ends the subscription.
    readonly TaskCompletionSource _ended = new();

    public Subscription(MessageHub hub, string topic, SubscriptionTerms terms, int standardQueue, DropCounters drops)
    {
        Topic = topic;
        _hub = hub;
        _terms = terms;
        // Does not count messages that are skipped because of the client's throttle rate.
        _lost = () => drops.Count(terms.ThrottleMs > 0 ? DropReason.None : DropReason.SlowReader);
        var bounds = new BoundedChannelOptions(QueueOf(topic, terms, standardQueue)) { FullMode = BoundedChannelFullMode.DropOldest, SingleReader = true };
        _times = RobotTopic.Parse(topic).Kind == RosTopics.JointStates && terms.ThrottleMs == 0 ? hub.Forwarding : null;
        if (CellKinds.IsLatched(topic))
        {
            _queue = Channel.CreateBounded<HubMessage>(bounds, message => _latched.Lose(message));
            _latched = new LatchedQueue(hub, topic, _queue, terms.ThrottleMs > 0, _lost);
            _subscriber = hub.SubscribeToNew(topic, message => _queue.Writer.TryWrite(message));
            _latched.Start();
        }
        else
        {
            _queue = Channel.CreateBounded<HubMessage>(bounds, message => _samples.Lose(message));
            _samples = new SampleQueue(hub, _queue, terms.ThrottleMs > 0, _lost);
            _subscriber = hub.Subscribe(topic, message => _queue.Writer.TryWrite(message));
            if (RobotTopic.Parse(topic).Kind == RosTopics.JointStates) _samples.Start(topic);
        }
    }

    public string Topic { get; }

    /// <summary>Sends messages until the subscription is disposed or sending fails.</summary>
    /// <param name="send">
    /// Waits until the client has room for a message, then calls its argument to select a message, and sends that message. The parameter of
    /// this argument is the time at which the last wait of a message for the client ended, a timestamp of the hub's time provider.
    /// </param>
    /// <param name="stop">Ends the wait of a throttled subscription.</param>
    public async Task PumpAsync(Func<Func<long, ReadOnlyMemory<byte>>, Task> send, CancellationToken stop)
    {
        // Passes no cancellation token, because it requires a registration for each message. The end of the connection disposes the subscription.
        while (HasMore || (_samples?.UnsentIn is { } wait ? await WaitToReadAsync(wait) : await _queue.Reader.WaitToReadAsync(CancellationToken.None)))
        {
            var began = _hub.Time.GetTimestamp();
            HubMessage message = null;
            var isKept = false;
            await send(waitedUntil => (message = Next(waitedUntil, out isKept))?.Utf8(_terms.Form) ?? default);
            if (message == null) continue;
            if (!isKept) _times?.Add(message.ReceivedAt);
            var rest = TimeSpan.FromMilliseconds(_terms.ThrottleMs) - _hub.Time.GetElapsedTime(began);
            if (rest > TimeSpan.Zero && _latched?.IsNextTogether != true && await IsOverWithinAsync(rest, stop))
                return;
        }
    }

    /// <summary>Counts the queued messages as dropped. Call this if the sending loop was never started.</summary>
    public void CountUnsent()
    {
        while (_queue.Reader.TryRead(out var message))
            if (message != LatchedQueue.Wake) _lost();
    }

    bool HasMore => (_latched?.HasMore == true || _samples?.UnsentIn == TimeSpan.Zero) && !_ended.Task.IsCompleted;

    // Returns the next message to send; null if the queue is empty. Each topic has its own queue, so a stationary pose and a moving pose of one frame
    // may leave their queues in another order than that of their publication. Without poses that no longer apply, the newest pose arrives last.
    HubMessage Next(long waitedUntil, out bool isKept)
    {
        while (Waiting(waitedUntil, out isKept) is { } message)
        {
            var applicable = message.Content is TransformsMessage ? _hub.Applicable(message) : message;
            if (applicable != null) return applicable;
        }

        return null;
    }

    HubMessage Waiting(long waitedUntil, out bool isKept)
    {
        if (_latched == null) return _samples.Next(waitedUntil, out isKept);
        isKept = false;
        return _latched.Next(receivedAt => SampleQueue.IsOld(receivedAt, waitedUntil, _hub.Time));
    }

    // Waits for a message in the queue, at most until the next sample that is not in the queue may be sent. Returns false at the end of the subscription.
    async Task<bool> WaitToReadAsync(TimeSpan wait)
    {
        using var over = new CancellationTokenSource(wait, _hub.Time);
        try
        {
            return await _queue.Reader.WaitToReadAsync(over.Token);
        }
        catch (OperationCanceledException)
        {
            return !_ended.Task.IsCompleted;
        }
    }

    // Returns whether the subscription ends during the wait. The wait must end early, because a throttle interval can be as long as a month.
    async Task<bool> IsOverWithinAsync(TimeSpan rest, CancellationToken stop)
    {
        await _ended.Task.WaitAsync(rest, _hub.Time, stop)
            .ConfigureAwait(ConfigureAwaitOptions.SuppressThrowing | ConfigureAwaitOptions.ContinueOnCapturedContext);
        return _ended.Task.IsCompleted || stop.IsCancellationRequested;
    }

    public void Dispose()
    {
        _subscriber.Dispose();
        _ended.TrySetResult();
        _queue.Writer.TryComplete();
    }

    // Without a queue length set by the client, a throttled subscription holds one message: the newest, sent at the end of each interval. Many sources
    // publish a message per object, all at the same time, so the queue of poses has room for each object of the largest cell.
    static int QueueOf(string topic, SubscriptionTerms terms, int standard)
    {
        if (terms.QueueLength > 0)
            return Math.Min(terms.QueueLength, MaxQueueLength);
        if (terms.ThrottleMs > 0) return 1;
        return topic == RosTopics.Tf ? Math.Max(standard, ProtocolLimits.Frames) : standard;
    }
}
