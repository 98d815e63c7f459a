using Nowpose.Gateway.Hub;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status.Events;

/// <summary>Set-points that are refused because of their content, or because another source publishes the joint. Thread-safe; bounded.</summary>
/// <remarks>
/// A source may send set-points only once per motion, so a refusal lasts until set-points of the same joint are accepted, or until one of the two sources
/// ends or unadvertises the topic.
/// </remarks>
sealed class RefusedSetPoints(TimeProvider time)
{
    /// <summary>Maximum number of refusals, in total and of one source.</summary>
    const int MaxRefusals = 64, MaxOfSource = 16;

    /// <summary>Minimum time for which a refusal lasts after the end of a source, because a source may connect for each message.</summary>
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly Lock _lock = new();
    readonly Dictionary<(HubSource Source, string Robot, string Joint), (Refusal Refusal, long At)> _refusals = [];

    /// <summary>Adds a refusal, or replaces the earlier one of the same joint.</summary>
    /// <param name="robot">Namespace of the robot; empty if it has none.</param>
    /// <param name="joint">The refused joint, or the first one of the message; empty if no name can be read.</param>
    public void Refuse(HubSource source, string robot, string joint, Refusal refusal)
    {
        lock (_lock)
        {
            var key = (source, robot, joint);
            if (_refusals.ContainsKey(key) || (_refusals.Count < MaxRefusals && _refusals.Keys.Count(known => known.Source == source) < MaxOfSource))
                _refusals[key] = (refusal, time.GetTimestamp());
        }
    }

    /// <summary>Removes the refusals of joints whose set-points are accepted now.</summary>
    public void Accept(HubSource source, string robot, string[] joints)
    {
        lock (_lock) Remove(known => known.Source == source && known.Robot == robot && (known.Joint.Length == 0 || joints.Contains(known.Joint)));
    }

    /// <summary>Removes the refusals of a source on a topic that it no longer publishes, and those because of this source.</summary>
    public void Release(HubSource source, string topic)
    {
        lock (_lock)
            Remove(known => (known.Source == source || _refusals[known].Refusal.Owner == source)
                && RobotTopic.NameOf(known.Robot, RosTopics.JointTrajectory) == topic);
    }

    /// <summary>Gets the refusals with the title of the source and the namespace of the robot.</summary>
    public IReadOnlyList<(string Source, string Robot, string Joint, Refusal Refusal)> Read()
    {
        lock (_lock)
        {
            Remove(known => (known.Source.IsEnded || _refusals[known].Refusal.Owner?.IsEnded == true) && time.GetElapsedTime(_refusals[known].At) > Span);
            return [.. _refusals.Select(one => (one.Key.Source.Title, one.Key.Robot, one.Key.Joint, one.Value.Refusal))];
        }
    }

    void Remove(Func<(HubSource Source, string Robot, string Joint), bool> isOver)
    {
        foreach (var key in _refusals.Keys.Where(isOver).ToList()) _refusals.Remove(key);
    }
}
