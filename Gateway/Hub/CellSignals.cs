using Nowpose.Protocol.Cell;
using Nowpose.Signals;

namespace Nowpose.Gateway.Hub;

/// <summary>The signals of the cell: their sources and their newest values. A signal is removed when its source ends. Not thread-safe.</summary>
/// <param name="publish">Gives a message its sequence number and publishes it.</param>
/// <param name="began">Called with signals that had no source before.</param>
/// <param name="ended">Called with the removed signals of a source.</param>
sealed class CellSignals(
    TimeProvider time, Action<HubMessage> publish, Action<IReadOnlyCollection<string>> began, Action<HubSource, IReadOnlyCollection<string>> ended)
{
    readonly RefusedValues<SignalsMessage> _refused = new(value => value.Stamp);

    /// <summary>The sources of all signals.</summary>
    public OwnerMap<string> Owners { get; } = new();

    public LatchedMessages Newest { get; } = new(Only);

    /// <summary>Publishes the signals of a message up to the maximum number of signals. Leaves out the others, and signals of other sources.</summary>
    /// <returns>Whether at least one signal was published.</returns>
    public bool Publish(HubSource source, SignalsMessage message, List<LeftOut> leftOut, long receivedAt)
    {
        HashSet<string> added = null;
        var accepted = MessageParts.Accepted(message, message.Count, IsAccepted, MessageParts.Part);
        if (added != null) began(added);
        foreach (var part in MessageParts.Of(accepted))
        {
            var published = new HubMessage(RosTopics.Signals, part, source, receivedAt);
            Latch(published);
            publish(published);
        }

        return accepted.Count > 0;

        bool IsAccepted(int index)
        {
            var name = message[index].Name;
            var owner = Owners[name];
            if (owner == source) return true;
            if (owner == null && Owners.Count < ProtocolLimits.Signals)
            {
                Owners.Take(source, name);
                (added ??= []).Add(name);
                return true;
            }

            var reason = owner == null ? DropReason.TooManySignals : DropReason.SignalTaken;
            if (owner != null) _refused.Keep(source, name, new SignalsMessage(message.Stamp, message[index]));
            leftOut.Add(new LeftOut(reason, name, CellMessageFaults.Of(CellMessageFaults.Named(CellKinds.Signal, name), reason), owner));
            return false;
        }
    }

    /// <summary>Removes the signals of a source that ends, and publishes the refused values of other sources for these signals.</summary>
    public void Release(HubSource source)
    {
        _refused.Remove(source);
        var removed = Owners.Release(source, _ => true);
        foreach (var name in removed) Newest.Remove(name);
        if (removed.Count > 0) ended(source, removed);
        // Each value has its own time stamp, so each one is a message.
        _refused.PublishFree(Owners, (other, values) =>
        {
            foreach (var value in values) Publish(other, value, [], time.GetTimestamp());
        });
    }

    // Keeps a message for later subscribers, for the signals of which it has the newest value.
    void Latch(HubMessage message)
    {
        var signals = (SignalsMessage)message.Content;
        for (var i = 0; i < signals.Count; i++)
        {
            var (name, value) = (signals[i].Name, signals[i].Value);
            if (Newest.Of(name)?.Content is not SignalsMessage newest) Newest.Set(name, message);
            else if (!LateValues.IsOvertaken(signals.Stamp, newest.Stamp)) Newest.Set(name, message, ValueIn(newest, name, i) != value);
        }
    }

    // Starts at an index, because a source usually sends its signals in the same order.
    static double ValueIn(SignalsMessage message, string name, int start)
    {
        var index = start % message.Count;
        while (message[index].Name != name) index = (index + 1) % message.Count;
        return message[index].Value;
    }

    static HubMessage Only(HubMessage message, Predicate<string> isCurrent)
    {
        var whole = (SignalsMessage)message.Content;
        var part = MessageParts.Part(whole, index => isCurrent(whole[index].Name));
        return part.Count == whole.Count ? message : message.With(part);
    }
}
