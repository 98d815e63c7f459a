using System.Diagnostics;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Status;

/// <summary>How often each source's joints come, and how old their samples are. Any thread; bounded.</summary>
/// <remarks>
/// A source is what shares joints: who tells changes only publishes now these joints and now those of one robot, in ever other sets. Arm and
/// gripper that are never published together are two.
/// </remarks>
sealed class SourceWatch
{
    /// <summary>Sources that are told apart; further ones are not watched until one is forgotten.</summary>
    internal const int Greatest = 64;

    /// <summary>Of all sources together; likewise.</summary>
    internal const int GreatestJoints = 4 * ProtocolLimits.Joints;

    static readonly TimeSpan ForgottenAfter = TimeSpan.FromSeconds(10);

    readonly Lock _lock = new();
    readonly Dictionary<string, SourceTrack> _byJoint = [];
    readonly List<SourceTrack> _tracks = [];

    bool IsFull => _tracks.Count >= Greatest || _byJoint.Count >= GreatestJoints;

    /// <param name="receivedAt">A count of <see cref="Stopwatch"/>.</param>
    /// <param name="age">C1 at the receipt less t_k.</param>
    public void Add(string[] names, long receivedAt, TimeSpan age)
    {
        lock (_lock)
        {
            var track = Known(names);
            if (track == null && IsFull) Forget(receivedAt);
            if (track == null && (IsFull || names.Length == 0)) return;
            if (track == null) _tracks.Add(track = new SourceTrack());
            foreach (var name in names)
                if (_byJoint.Count < GreatestJoints && _byJoint.TryAdd(name, track)) track.Joints.Add(name);
            track.Add(receivedAt, age);
        }
    }

    /// <summary>Those that publish, with the ages of their samples lately.</summary>
    public IReadOnlyList<(string[] Names, double RateHz, TimeSpan[] SortedAges)> Read() => Read(Stopwatch.GetTimestamp());

    internal IReadOnlyList<(string[] Names, double RateHz, TimeSpan[] SortedAges)> Read(long now)
    {
        (string[] Names, (long At, TimeSpan Age)[] Samples)[] copies;
        // Who publishes waits for the copies, not for the sorting.
        lock (_lock)
        {
            Forget(now);
            copies = [.. _tracks.Select(track => (track.Joints.ToArray(), track.Recent(now)))];
        }

        return [.. copies.Select(copy => (copy.Names, RateHz(copy.Samples, now), copy.Samples.Select(sample => sample.Age).Order().ToArray()))];
    }

    // Sources that turn out to be one become one.
    SourceTrack Known(string[] names)
    {
        SourceTrack known = null;
        foreach (var name in names)
        {
            if (!_byJoint.TryGetValue(name, out var track) || track == known) continue;
            if (known == null)
            {
                known = track;
                continue;
            }

            known.Take(track);
            _tracks.Remove(track);
            foreach (var joint in track.Joints) _byJoint[joint] = known;
        }

        return known;
    }

    void Forget(long now)
    {
        foreach (var track in _tracks.Where(track => Stopwatch.GetElapsedTime(track.Newest, now) > ForgottenAfter).ToArray())
        {
            _tracks.Remove(track);
            foreach (var joint in track.Joints) _byJoint.Remove(joint);
        }
    }

    static double RateHz((long At, TimeSpan Age)[] samples, long now)
    {
        if (samples.Length < 2) return 0;
        // To now, not to the newest: a source that stops becomes slower before it is gone.
        var (first, last) = (samples.Min(sample => sample.At), samples.Max(sample => sample.At));
        return (samples.Length - 1) / Math.Max(1e-6, Stopwatch.GetElapsedTime(first, Math.Max(now, last)).TotalSeconds);
    }
}
