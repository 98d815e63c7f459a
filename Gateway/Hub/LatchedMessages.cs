namespace Nowpose.Gateway.Hub;

/// <summary>The newest message for each name on a topic, where a name is a frame or a signal. Not thread-safe.</summary>
/// <param name="only">Returns a copy of a message with only the names that fulfil the condition.</param>
sealed class LatchedMessages(Func<HubMessage, Predicate<string>, HubMessage> only)
{
    readonly Dictionary<string, HubMessage> _newest = [];

    public void Set(string name, HubMessage message) => _newest[name] = message;

    /// <summary>Gets the message for a name; null if there is none.</summary>
    public HubMessage Of(string name) => _newest.GetValueOrDefault(name);

    public void Remove(string name) => _newest.Remove(name);

    /// <summary>Gets the current values that were published since a sequence number, in the order of publication.</summary>
    /// <param name="sequence">Minimum <see cref="HubMessage.Sequence"/>.</param>
    public IEnumerable<HubMessage> Since(long sequence) => _newest.Values.Where(message => message.Sequence >= sequence).Distinct()
        .OrderBy(message => message.Sequence).Select(message => only(message, name => _newest.GetValueOrDefault(name) == message)).ToArray();
}
