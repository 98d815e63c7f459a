namespace Nowpose.Gateway.Hub;

/// <summary>The newest message for each name on a topic, where a name is a frame or a signal. Not thread-safe.</summary>
/// <param name="only">Returns a copy of a message with only the names that fulfil the condition.</param>
sealed class LatchedMessages(Func<HubMessage, Predicate<string>, HubMessage> only)
{
    readonly Dictionary<string, HubMessage> _newest = [];
    // The newest message with another value than the newest one.
    readonly Dictionary<string, HubMessage> _former = [];

    /// <param name="isChange">Whether the value differs from the newest one, which is then also kept for readers that have missed it.</param>
    public void Set(string name, HubMessage message, bool isChange = false)
    {
        if (isChange && Of(name) is { } former) _former[name] = former;
        _newest[name] = message;
    }

    /// <summary>Gets the message for a name; null if there is none.</summary>
    public HubMessage Of(string name) => _newest.GetValueOrDefault(name);

    public void Remove(string name)
    {
        _newest.Remove(name);
        _former.Remove(name);
    }

    /// <summary>
    /// Gets the current values that were published since a sequence number, in the order of publication. Each one follows the newest different value, if
    /// it is recent too, so that a reader receives a change also if the value has changed back.
    /// </summary>
    /// <param name="sequence">Minimum <see cref="HubMessage.Sequence"/> of the current values.</param>
    /// <param name="changesAfter">Different values must also have a higher sequence number than this function returns for their name.</param>
    public IEnumerable<HubMessage> Since(long sequence, Func<string, long> changesAfter)
    {
        bool IsFormer(HubMessage message, string name) => _former.GetValueOrDefault(name) == message && message.Sequence > changesAfter(name);
        var former = _former.Where(one => one.Value.Sequence > changesAfter(one.Key)).Select(one => one.Value);
        return _newest.Values.Concat(former).Where(message => message.Sequence >= sequence).Distinct().OrderBy(message => message.Sequence)
            .Select(message => only(message, name => Of(name) == message || IsFormer(message, name))).ToArray();
    }
}
