using System.Diagnostics;
using System.Threading.Channels;
using Nowpose.Gateway.Hub;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// The queue of a subscription to a topic that is latched per name. When it loses messages, the newest values of the names in them are
/// sent: a signal may not change again for hours, so its newest value must arrive.
/// </summary>
/// <remarks>The hub's lock orders publishing and reading of latched values, so that no value is missed and none is older than one sent before.</remarks>
/// <param name="lost">Counts a message that is not sent.</param>
sealed class LatchedQueue(MessageHub hub, string topic, Channel<HubMessage> queue, Action lost)
{
    const long None = long.MaxValue;

    /// <summary>An entry that only wakes the loop that sends.</summary>
    public static readonly HubMessage Wake = HubMessage.Description("");

    // Values read from the hub, which precede the messages in the queue.
    readonly Queue<HubMessage> _read = [];
    // Number of the first message that was lost; at the start, all messages are.
    long _lostFrom;
    long _readAt;

    /// <summary>Whether values wait outside of the queue.</summary>
    public bool HasMore => _read.Count > 0;

    /// <summary>Starts with the current values. Call this after the subscription.</summary>
    public void Start() => queue.Writer.TryWrite(Wake);

    /// <summary>Takes a message that was dropped from the full queue. Called under the hub's lock, or at the start.</summary>
    public void Lose(HubMessage message)
    {
        if (message == Wake) return;
        lost();
        if (message.Sequence < Volatile.Read(ref _lostFrom)) Volatile.Write(ref _lostFrom, message.Sequence);
    }

    /// <summary>Takes the next message; null if there is none. For one thread at a time.</summary>
    /// <param name="isOld">
    /// Returns whether a message received at a time, a count of <see cref="Stopwatch"/>, has waited too long for the client.
    /// The newest values are then sent instead.
    /// </param>
    public HubMessage Next(Func<long, bool> isOld)
    {
        if (Volatile.Read(ref _lostFrom) != None || (HasMore && isOld(_readAt))) ReadAgain(None);
        while (true)
        {
            if (_read.TryDequeue(out var message)) return message;
            if (!queue.Reader.TryRead(out message)) return null;
            if (message == Wake) continue;
            // An earlier message may have been lost since the start of this method.
            if (!isOld(message.ReceivedAt) && Volatile.Read(ref _lostFrom) > message.Sequence) return message;
            ReadAgain(message.Sequence);
        }
    }

    // Replaces the waiting messages by the newest values.
    void ReadAgain(long from)
    {
        var waiting = new List<long>();
        if (from != None) waiting.Add(from);
        waiting.AddRange(_read.Select(message => message.Sequence));
        _read.Clear();
        _readAt = Stopwatch.GetTimestamp();
        foreach (var message in hub.ReadLatched(topic, () =>
        {
            while (queue.Reader.TryRead(out var queued))
                if (queued != Wake) waiting.Add(queued.Sequence);
            return Math.Min(Interlocked.Exchange(ref _lostFrom, None), waiting.Count == 0 ? None : waiting.Min());
        })) _read.Enqueue(message);

        foreach (var _ in waiting.Except(_read.Select(message => message.Sequence))) lost();
    }
}
