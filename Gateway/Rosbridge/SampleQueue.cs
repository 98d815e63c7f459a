using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// The queue of a subscription to a topic that is not latched per name. Drops samples that have waited too long for a slow reader, but never the newest
/// sample of a joint or frame, because a source may send a sample only when the value changes.
/// </summary>
/// <remarks>
/// A new subscriber receives the newest joint states that were published before, from the time at which their joints are at rest. Joints that move are
/// not affected, because their next sample replaces the newest one.
/// </remarks>
/// <param name="isThrottled">Whether the client wants at most one message in an interval. It then receives a dropped sample only of a joint or frame at rest.</param>
/// <param name="lost">Called for each message that the queue drops, even if a part of it is sent later.</param>
sealed class SampleQueue(MessageHub hub, Channel<HubMessage> queue, bool isThrottled, Action lost)
{
    /// <summary>Maximum time for which a sample waits for a slow reader. An older sample is dropped if a newer one is queued.</summary>
    static readonly TimeSpan MaxSampleAge = TimeSpan.FromMilliseconds(150);

    readonly Lock _lock = new();

    // Newest samples that are not in the queue, by joint or frame, each with the timestamp from which it may be sent.
    readonly Dictionary<string, (HubMessage Message, long From)> _unsent = [];

    /// <summary>Time until the next sample that is not in the queue may be sent; null if there is none.</summary>
    public TimeSpan? UnsentIn
    {
        get
        {
            lock (_lock)
            {
                if (_unsent.Count == 0) return null;
                var wait = hub.Time.GetElapsedTime(hub.Time.GetTimestamp(), _unsent.Values.Min(one => one.From));
                return wait < TimeSpan.Zero ? TimeSpan.Zero : wait;
            }
        }
    }

    /// <summary>Returns whether a message has waited too long for the client.</summary>
    /// <param name="receivedAt">Time at which the message was received, a timestamp of the hub's time provider.</param>
    /// <param name="waitedUntil">Time at which the last wait of a message for the client ended, a timestamp of the hub's time provider.</param>
    public static bool IsOld(long receivedAt, long waitedUntil, TimeProvider time) =>
        receivedAt < waitedUntil && time.GetElapsedTime(receivedAt) > MaxSampleAge;

    /// <summary>Keeps the newest joint states on a topic for the client. Call this method after the subscription, so that none is missed.</summary>
    public void Start(string topic)
    {
        foreach (var message in hub.Samples.On(topic)) Keep(message, RestOf(message));
    }

    /// <summary>Records a message that was dropped from the full queue. Thread-safe.</summary>
    public void Lose(HubMessage message)
    {
        lost();
        Keep(message, isThrottled ? RestOf(message) : 0);
    }

    /// <summary>Removes and returns the next message; null if there is none. Not thread-safe.</summary>
    /// <param name="isKept">Whether the message was not in the queue, so that the time since its receipt is not a forwarding time.</param>
    /// <inheritdoc cref="IsOld" path="/param[@name='waitedUntil']"/>
    public HubMessage Next(long waitedUntil, out bool isKept)
    {
        var unsent = Unsent();
        isKept = unsent != null;
        if (isKept) return unsent;
        while (queue.Reader.TryRead(out var message))
        {
            // Drops only messages that waited for the client. A message that waited for another reason, such as a busy processor, is sent late.
            var isSample = message.Content is JointStateMessage or TransformsMessage;
            if (!isSample || !IsOld(message.ReceivedAt, waitedUntil, hub.Time) || !queue.Reader.TryPeek(out _)) return Sent(message);
            string[] newest = [.. MessageParts.NamesIn(message).Where(name => hub.Samples.IsNewest(message, name))];
            if (newest.Length > 0) return MessageParts.Only(Sent(message), newest.Contains);
            lost();
        }

        return null;
    }

    // Returns the time at which the joints or frames of a message are at rest if no newer sample has arrived: after one second.
    long RestOf(HubMessage message) => message.ReceivedAt + hub.Time.TimestampFrequency;

    void Keep(HubMessage message, long from)
    {
        // The check is under the lock, so that no older message replaces a newer one.
        lock (_lock)
            foreach (var name in MessageParts.NamesIn(message))
                if (hub.Samples.IsNewest(message, name)) _unsent[name] = (message, from);
    }

    // A message that was published during the subscription is both in the queue and among the newest ones.
    HubMessage Sent(HubMessage message)
    {
        lock (_lock)
            foreach (var (name, one) in _unsent)
                if (one.Message == message) _unsent.Remove(name);
        return message;
    }

    // Removes and returns the earliest sample that may be sent; null if there is none.
    HubMessage Unsent()
    {
        lock (_lock)
        {
            if (_unsent.Count == 0) return null;
            foreach (var (name, one) in _unsent)
                if (!hub.Samples.IsNewest(one.Message, name)) _unsent.Remove(name);
            var now = hub.Time.GetTimestamp();
            var first = _unsent.Values.Where(one => one.From <= now).Select(one => one.Message).MinBy(message => message.ReceivedAt);
            if (first == null) return null;
            HashSet<string> names = [.. _unsent.Where(one => one.Value.Message == first).Select(one => one.Key)];
            foreach (var name in names) _unsent.Remove(name);
            return MessageParts.Only(first, names.Contains);
        }
    }
}
