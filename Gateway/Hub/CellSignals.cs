using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Gateway.Hub;

/// <summary>The signals of the cell: their sources and their newest values. A signal is removed when its source ends. Not thread-safe.</summary>
sealed class CellSignals
{
    readonly Dictionary<string, HubSource> _owners = [];

    public LatchedMessages Newest { get; } = new(Only);

    /// <summary>Returns a refusal if the message contains a signal of another source; null otherwise.</summary>
    public Refusal? FindTaken(HubSource source, SignalsMessage message)
    {
        for (var i = 0; i < message.Count; i++)
            if (_owners.TryGetValue(message[i].Name, out var owner) && owner != source)
                return new Refusal(DropReason.SignalTaken, $"signal {message[i].Name}", owner);
        return null;
    }

    /// <summary>Adds the signals of a message up to the maximum number of signals, and leaves out the others.</summary>
    /// <returns>The message itself if all its signals were accepted; otherwise a message with the accepted ones, which may be empty.</returns>
    /// <param name="began">Called with the signals that had no source before, unless there are none.</param>
    public SignalsMessage Accept(HubSource source, SignalsMessage message, List<LeftOut> leftOut, Action<IReadOnlyCollection<string>> began)
    {
        HashSet<string> added = null;
        SignalsMessage accepted = null;
        for (var i = 0; i < message.Count; i++)
        {
            var name = message[i].Name;
            if (_owners.ContainsKey(name) || _owners.Count < ProtocolLimits.Signals)
            {
                if (_owners.TryAdd(name, source)) (added ??= []).Add(name);
                accepted?.Add(message[i]);
                continue;
            }

            leftOut.Add(new LeftOut(DropReason.TooManySignals, $"signal {name}"));
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
