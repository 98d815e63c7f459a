using System.Diagnostics;
using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Gateway.Status;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>One client's subscription to one topic: a queue that loses its oldest message, and who empties it.</summary>
sealed class Subscription : IDisposable
{
    const int LongestQueue = 1024;

    /// <summary>Samples that have waited longer for a slow reader are dropped where a newer one waits.</summary>
    internal static readonly TimeSpan MaxSampleAge = TimeSpan.FromMilliseconds(150);

    readonly Channel<HubMessage> _queue;
    readonly IDisposable _subscriber;
    readonly ForwardingTimes _times;
    readonly SubscriptionTerms _terms;
    readonly Action _lost;
    readonly TaskCompletionSource _ended = new(TaskCreationOptions.RunContinuationsAsynchronously);

    public Subscription(MessageHub hub, string topic, SubscriptionTerms terms, int standardQueue, DropCounters drops)
    {
        Topic = topic;
        _terms = terms;
        // What a client does not want that often is not lost to it.
        _lost = () => drops.Count(terms.ThrottleMs > 0 ? DropReason.None : DropReason.SlowReader);
        var bounds = new BoundedChannelOptions(QueueOf(terms, standardQueue)) { FullMode = BoundedChannelFullMode.DropOldest, SingleReader = true };
        _queue = Channel.CreateBounded<HubMessage>(bounds, _ => _lost());
        _times = topic == RosTopics.JointStates && terms.ThrottleMs == 0 ? hub.Forwarding : null;
        _subscriber = hub.Subscribe(topic, message => _queue.Writer.TryWrite(message));
    }

    public string Topic { get; }

    /// <summary>Sends what comes until the subscription is disposed or sending fails.</summary>
    /// <param name="send">
    /// Sends the message that it takes when the client has room for one. It passes until when messages had to wait for the client, a count of
    /// <see cref="Stopwatch"/>.
    /// </param>
    public async Task PumpAsync(Func<Func<long, ReadOnlyMemory<byte>>, Task> send, CancellationToken stop)
    {
        while (await _queue.Reader.WaitToReadAsync(stop))
        {
            var began = Stopwatch.GetTimestamp();
            HubMessage message = null;
            await send(waitedUntil => (message = Next(waitedUntil))?.Utf8(_terms.Form) ?? default);
            if (message == null) continue;
            _times?.Add(message.ReceivedAt);
            var rest = TimeSpan.FromMilliseconds(_terms.ThrottleMs) - Stopwatch.GetElapsedTime(began);
            if (rest > TimeSpan.Zero && await IsOverWithinAsync(rest, stop))
                return;
        }
    }

    /// <summary>Of one that nobody empties: what waits in it is lost.</summary>
    public void CountUnsent()
    {
        while (_queue.Reader.TryRead(out _))
            _lost();
    }

    // Null when the queue was emptied meanwhile.
    HubMessage Next(long waitedUntil)
    {
        while (_queue.Reader.TryRead(out var message))
        {
            // What waited for something else than the client, such as a busy processor, is sent late rather than never.
            var isOld = message.Content is JointStateMessage && message.ReceivedAt < waitedUntil
                && Stopwatch.GetElapsedTime(message.ReceivedAt) > MaxSampleAge;
            if (!isOld || !_queue.Reader.TryPeek(out _)) return message;
            _lost();
        }

        return null;
    }

    // A client may ask for a message a month: unsubscribed, nobody waits for the next one.
    async Task<bool> IsOverWithinAsync(TimeSpan rest, CancellationToken stop)
    {
        using var waited = CancellationTokenSource.CreateLinkedTokenSource(stop);
        var first = await Task.WhenAny(_ended.Task, Task.Delay(rest, waited.Token));
        await waited.CancelAsync();
        return first == _ended.Task || stop.IsCancellationRequested;
    }

    public void Dispose()
    {
        _subscriber.Dispose();
        _ended.TrySetResult();
        _queue.Writer.TryComplete();
    }

    // A throttled client that names no queue gets the newest there is when its time has come.
    static int QueueOf(SubscriptionTerms terms, int standard)
    {
        if (terms.QueueLength > 0)
            return Math.Min(terms.QueueLength, LongestQueue);
        return terms.ThrottleMs > 0 ? 1 : standard;
    }
}
