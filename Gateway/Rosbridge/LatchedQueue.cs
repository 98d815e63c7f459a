using System.Threading.Channels;
using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Rosbridge;

/// <summary>
/// The queue of a subscription to a topic that is latched per name. If the queue drops messages, it later sends the newest value of each
/// name in them, because a signal may not change again for hours and its newest value must arrive. It sends the newest different value before, if it was
/// dropped too, because a signal that changes and changes back may release a gripped object. A throttled client gets only the newest
/// of the dropped values, and the messages that are in the queue one by one.
/// </summary>
/// <remarks>
/// The hub publishes and reads latched values under its lock, so that no value is missed and no older value follows a newer one.
/// </remarks>
/// <param name="isThrottled">Whether the client wants at most one value of each name in an interval.</param>
/// <param name="lost">Called for each message that is not sent.</param>
sealed class LatchedQueue(MessageHub hub, string topic, Channel<HubMessage> queue, bool isThrottled, Action lost)
{
    const long None = long.MaxValue;

    /// <summary>Maximum number of remembered names: more than the cell can have at a time, because names end with their sources.</summary>
    const int MaxNames = 4 * ProtocolLimits.Signals;

    /// <summary>A queue entry without content that wakes the sending loop.</summary>
    public static readonly HubMessage Wake = new(null, null, null, 0);

    // Values read from the hub. They are sent before the messages in the queue.
    readonly Queue<HubMessage> _read = [];
    // Sequence number of the first dropped message. Initially 0, so that all current values are sent.
    long _lostFrom;
    long _readAt;
    // A value that is no longer the newest is read only if its sequence number is higher than those of the first reading and of the last sent message of
    // its name.
    long _changesAfter = None;
    // Highest sequence number of the sent messages of each name.
    readonly Dictionary<string, long> _sent = [];
    // Sequence number of the first value of each name that was read from the hub after its last sent value.
    readonly Dictionary<string, long> _waitingSince = [];
    // Number of values that may still be sent without a pause.
    int _together;

    /// <summary>Whether values read from the hub are waiting to be sent.</summary>
    public bool HasMore => _read.Count > 0;

    /// <summary>
    /// Whether the next value was read from the hub together with the previous one, so that a throttled client gets it without a pause. A repeated reading
    /// before the pause allows no further values, because otherwise a client that is slower than the changes would get no pause.
    /// </summary>
    public bool IsNextTogether => _together > 0;

    /// <summary>Sends the current values. Call this method after the subscription.</summary>
    public void Start() => queue.Writer.TryWrite(Wake);

    /// <summary>Records a message that was dropped from the full queue. Called under the hub's lock, or before the subscription starts.</summary>
    public void Lose(HubMessage message)
    {
        if (message == Wake) return;
        lost();
        if (message.Sequence < Volatile.Read(ref _lostFrom)) Volatile.Write(ref _lostFrom, message.Sequence);
    }

    /// <summary>Removes and returns the next message; null if there is none. Not thread-safe.</summary>
    /// <param name="isOld">
    /// Returns whether a message has waited too long for the client, so that the newest values are sent instead. The argument is the time at
    /// which the message was received, a timestamp of the hub's time provider.
    /// </param>
    public HubMessage Next(Func<long, bool> isOld)
    {
        var message = Waiting(isOld);
        _together = Math.Min(_read.Count, _together > 0 ? _together - 1 : int.MaxValue);
        if (message != null) Remember(message);
        return message;
    }

    void Remember(HubMessage message)
    {
        foreach (var name in MessageParts.NamesIn(message))
        {
            // A drop may be reported after a newer message was taken from the queue.
            _sent[name] = Math.Max(message.Sequence, _sent.GetValueOrDefault(name));
            _waitingSince.Remove(name);
        }

        if (_sent.Count <= MaxNames) return;
        // The sources of most names have ended.
        _changesAfter = _sent.Values.Max();
        _sent.Clear();
        _waitingSince.Clear();
    }

    HubMessage Waiting(Func<long, bool> isOld)
    {
        // A throttled client gets the values of one reading, so that it gets each name once in an interval.
        var isAnyLost = Volatile.Read(ref _lostFrom) != None && !(isThrottled && IsNextTogether);
        if (isAnyLost || (HasMore && isOld(_readAt))) ReadAgain(None);
        while (true)
        {
            if (_read.TryDequeue(out var message)) return message;
            if (!queue.Reader.TryRead(out message)) return null;
            if (message == Wake) continue;
            // Checks again, because the queue may have dropped an earlier message since the start of this method.
            if (!isOld(message.ReceivedAt) && Volatile.Read(ref _lostFrom) > message.Sequence) return message;
            ReadAgain(message.Sequence);
        }
    }

    // Replaces each waiting message with the newest value of its name and the different value before it.
    void ReadAgain(long from)
    {
        var waiting = new List<long>();
        if (from != None) waiting.Add(from);
        HubMessage[] earlier = [.. _read];
        waiting.AddRange(earlier.Select(message => message.Sequence));
        _read.Clear();
        _readAt = hub.Time.GetTimestamp();
        var read = hub.ReadLatched(topic, () =>
        {
            while (queue.Reader.TryRead(out var queued))
                if (queued != Wake) waiting.Add(queued.Sequence);
            return Math.Min(Interlocked.Exchange(ref _lostFrom, None), waiting.Count == 0 ? None : waiting.Min());
        }, name => isThrottled ? None : Math.Max(_changesAfter, _sent.GetValueOrDefault(name)));
        HubMessage[] unsent = [.. read.Where(IsUnsent)];
        // Names that end before a value is sent would accumulate.
        if (_waitingSince.Count > MaxNames) _waitingSince.Clear();
        foreach (var message in earlier.Concat(unsent))
            foreach (var name in MessageParts.NamesIn(message)) _waitingSince.TryAdd(name, message.Sequence);
        foreach (var message in LongestWaitingFirst(unsent)) _read.Enqueue(message);
        if (_changesAfter == None) _changesAfter = _read.Count == 0 ? 0 : _read.Max(message => message.Sequence);
        foreach (var _ in waiting.Except(_read.Select(message => message.Sequence))) lost();
    }

    bool IsUnsent(HubMessage message) => MessageParts.NamesIn(message).Any(name => message.Sequence > _sent.GetValueOrDefault(name));

    // Sorts messages by the times since which their names have been waiting. In the order of publication, a name that changes during each send would come
    // before the others again. Messages of one name stay in the order of publication.
    IEnumerable<HubMessage> LongestWaitingFirst(HubMessage[] messages)
    {
        var since = new long[messages.Length];
        var later = new Dictionary<string, long>();
        for (var i = messages.Length - 1; i >= 0; i--)
        {
            string[] names = [.. MessageParts.NamesIn(messages[i])];
            since[i] = names.Min(name => Math.Min(_waitingSince[name], later.GetValueOrDefault(name, None)));
            foreach (var name in names) later[name] = since[i];
        }
        return messages.Zip(since).OrderBy(one => one.Second).Select(one => one.First);
    }
}
