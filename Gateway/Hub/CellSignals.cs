using Nowpose.Gateway.Messages;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>The signals of the cell: their sources and their newest values. A signal is removed when its source ends. Not thread-safe.</summary>
sealed class CellSignals
{
    readonly Dictionary<string, HubSource> _owners = [];

    public LatchedMessages Newest { get; } = new(Only);

    /// <summary>Returns the source that owns a signal, if it is another one; null otherwise.</summary>
    public HubSource OtherOwner(HubSource source, string signal) => _owners.TryGetValue(signal, out var owner) && owner != source ? owner : null;

    /// <summary>Adds the signals of a message up to the maximum number of signals. Leaves out the others, and signals of other sources.</summary>
    /// <returns>The message itself if all its signals were accepted; otherwise a message with the accepted ones, which may be empty.</returns>
    /// <param name="began">Called with the signals that had no source before, unless there are none.</param>
    public SignalsMessage Accept(HubSource source, SignalsMessage message, List<LeftOut> leftOut, Action<IReadOnlyCollection<string>> began)
    {
        HashSet<string> added = null;
        SignalsMessage accepted = null;
        for (var i = 0; i < message.Count; i++)
        {
            var name = message[i].Name;
            var owner = OtherOwner(source, name);
            if (owner == null && (_owners.ContainsKey(name) || _owners.Count < ProtocolLimits.Signals))
            {
                if (_owners.TryAdd(name, source)) (added ??= []).Add(name);
                accepted?.Add(message[i]);
                continue;
            }

            var reason = owner == null ? DropReason.TooManySignals : DropReason.SignalTaken;
            leftOut.Add(new LeftOut(reason, name, CellMessageFaults.Of(CellMessageFaults.Named(CellKinds.Signal, name), reason), owner));
            accepted ??= MessageParts.Part(message, index => index < i);
        }

        if (added != null) began?.Invoke(added);
        return accepted ?? message;
    }

    /// <summary>Removes the signals of a source that ends.</summary>
    /// <returns>The removed signals.</returns>
    public IReadOnlyCollection<string> Release(HubSource source)
    {
        HashSet<string> ended = [.. _owners.Where(one => one.Value == source).Select(one => one.Key)];
        foreach (var name in ended)
        {
            _owners.Remove(name);
            Newest.Remove(name);
        }

        return ended;
    }

    static HubMessage Only(HubMessage message, Predicate<string> isCurrent)
    {
        var whole = (SignalsMessage)message.Content;
        var part = MessageParts.Part(whole, index => isCurrent(whole[index].Name));
        return part.Count == whole.Count ? message : HubMessage.Of(part, message.ReceivedAt, message.Source).With(message.Sequence);
    }
}
