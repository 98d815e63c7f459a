using Nowpose.Gateway.Hub;

namespace Nowpose.Gateway.Status.Events;

/// <summary>
/// Set-points that are refused because of their content, or because another source publishes the joint; and invalid descriptions of robots that have
/// a valid one. Thread-safe; bounded.
/// </summary>
/// <remarks>
/// A source may send set-points only once per motion, and a description only once, so a refusal lasts until set-points of the same joint or a
/// description of the same robot are accepted, or until one of the two sources ends or unadvertises the topic. A refusal of set-points also ends if
/// the source sends set-points of other joints or robots and does not repeat the refused ones for a while, because the source may have changed to
/// these joints. The refusals of clients that may not publish set-points end soon after the last message and give way to others, because these
/// clients could otherwise hide the refusals of sources.
/// </remarks>
sealed class LastingRefusals(TimeProvider time)
{
    /// <summary>Maximum number of refusals, in total and of one source.</summary>
    const int MaxRefusals = 64, MaxOfSource = 16;

    /// <summary>
    /// Minimum time for which a refusal lasts after the end of a source, because a source may connect for each message; and time for which
    /// the refusal of a client that may not publish lasts.
    /// </summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    /// <summary>
    /// Time from the first accepted set-points of the source for other joints until a refusal ends that is not repeated. Longer than the cycle of most
    /// machines, so that set-points that are refused once per cycle are one event.
    /// </summary>
    static readonly TimeSpan MaxCycle = TimeSpan.FromMinutes(2);

    readonly Lock _lock = new();
    // FollowedAt: when other set-points of the source were first accepted since.
    readonly Dictionary<(HubSource Source, string Topic, string Joint), (Refusal Refusal, long At, long? FollowedAt)> _refusals = [];

    /// <summary>Adds a refusal, or replaces the earlier one of the same joint.</summary>
    /// <param name="topic">Topic of the message, with the robot's namespace.</param>
    /// <param name="joint">The refused joint, or the first one of the message; empty if no name can be read, and for a description.</param>
    public void Refuse(HubSource source, string topic, string joint, Refusal refusal)
    {
        lock (_lock)
        {
            RemoveOld();
            var key = (source, topic, joint);
            if (_refusals.ContainsKey(key) || (_refusals.Keys.Count(known => known.Source == source) < MaxOfSource && MakeRoom(refusal)))
                _refusals[key] = (refusal, time.GetTimestamp(), null);
        }
    }

    /// <summary>
    /// Removes the refusals that an accepted message ends: for a description those of all sources, because headsets no longer show the earlier one.
    /// Set-points mark the refusals of other set-points of the source.
    /// </summary>
    /// <param name="topic">Topic of the message, with the robot's namespace.</param>
    /// <param name="joints">The joints of the set-points; null for a description.</param>
    public void Accept(HubSource source, string topic, string[] joints)
    {
        lock (_lock)
        {
            if (_refusals.Count == 0) return;
            Remove(known => known.Topic == topic
                && (joints == null || (known.Source == source && (known.Joint.Length == 0 || joints.Contains(known.Joint)))));
            if (joints == null) return;
            foreach (var (key, known) in _refusals)
                if (key.Source == source && known.Refusal.Reason != DropReason.NotUrdf)
                    _refusals[key] = known with { FollowedAt = known.FollowedAt ?? time.GetTimestamp() };
        }
    }

    /// <summary>Removes the refusals of a source on a topic that it no longer publishes, and those because of this source.</summary>
    public void Release(HubSource source, string topic)
    {
        lock (_lock)
            Remove(known => (known.Source == source || _refusals[known].Refusal.Owner == source) && known.Topic == topic);
    }

    /// <summary>Gets the refusals with the title of the source.</summary>
    public IReadOnlyList<(string Source, string Topic, string Joint, Refusal Refusal)> Read()
    {
        lock (_lock)
        {
            RemoveOld();
            return [.. _refusals.Select(one => (one.Key.Source.Title, one.Key.Topic, one.Key.Joint, one.Value.Refusal))];
        }
    }

    // At the maximum, a refusal replaces one of a client that may not publish. Returns whether there is room.
    bool MakeRoom(Refusal refusal)
    {
        if (_refusals.Count < MaxRefusals) return true;
        if (refusal.Reason == DropReason.NotAllowed) return false;
        foreach (var (key, known) in _refusals)
            if (known.Refusal.Reason == DropReason.NotAllowed) return _refusals.Remove(key);
        return false;
    }

    void RemoveOld() => Remove(known =>
    {
        var (refusal, at, followedAt) = _refusals[known];
        var isOver = refusal.Reason == DropReason.NotAllowed || known.Source.IsEnded || refusal.Owner?.IsEnded == true;
        return (isOver && time.GetElapsedTime(at) > Span) || (followedAt is { } since && time.GetElapsedTime(since) > MaxCycle);
    });

    void Remove(Func<(HubSource Source, string Topic, string Joint), bool> isOver)
    {
        foreach (var key in _refusals.Keys.Where(isOver).ToList()) _refusals.Remove(key);
    }
}
