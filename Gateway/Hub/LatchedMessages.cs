namespace Nowpose.Gateway.Hub;

/// <summary>The newest message of each name on a topic. Not thread-safe.</summary>
/// <param name="only">Returns a copy of a message that contains only the accepted names.</param>
sealed class LatchedMessages(Func<HubMessage, Predicate<string>, HubMessage> only)
{
    readonly Dictionary<string, HubMessage> _newest = [];

    public void Set(string name, HubMessage message) => _newest[name] = message;

    public void Remove(string name) => _newest.Remove(name);

    /// <summary>Gets the current values that were published from a number on, in the order of publication.</summary>
    /// <param name="sequence">See <see cref="HubMessage.Sequence"/>.</param>
    public IEnumerable<HubMessage> Since(long sequence) => _newest.Values.Where(message => message.Sequence >= sequence).Distinct()
        .OrderBy(message => message.Sequence).Select(message => only(message, name => _newest.GetValueOrDefault(name) == message)).ToArray();
}
