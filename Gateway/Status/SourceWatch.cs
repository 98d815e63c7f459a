namespace Nowpose.Gateway.Status;

/// <summary>Measures the sample rate of each source and the ages of its samples. Thread-safe; bounded.</summary>
/// <remarks>
/// Messages with a common joint belong to the same source, because a publisher that sends only changes names other joints of its robot in each
/// message. An arm and a gripper that are never published together are two sources.
/// </remarks>
/// <param name="time">Time source of the receipt; null for the system's.</param>
sealed class SourceWatch(TimeProvider time = null)
{
    /// <summary>Maximum number of sources. Further sources are ignored until one is removed.</summary>
    internal const int MaxSources = 64;

    /// <summary>Maximum number of joints of all sources together.</summary>
    internal const int MaxJoints = 4 * ProtocolLimits.Joints;

    static readonly TimeSpan ForgottenAfter = TimeSpan.FromSeconds(10);

    readonly TimeProvider _time = time ?? TimeProvider.System;
    readonly Lock _lock = new();
    readonly Dictionary<string, SourceTrack> _byJoint = [];
    readonly List<SourceTrack> _tracks = [];

    bool IsFull => _tracks.Count >= MaxSources || _byJoint.Count >= MaxJoints;

    /// <summary>Adds a sample.</summary>
    /// <param name="names">Joints of the sample.</param>
    /// <param name="receivedAt">Time of the receipt, a timestamp of the time provider.</param>
    /// <param name="age">C1 at the receipt minus t_k.</param>
    public void Add(string[] names, long receivedAt, TimeSpan age)
    {
        lock (_lock)
        {
            var track = Known(names);
            if (track == null && IsFull) Forget(receivedAt);
            if (track == null && (IsFull || names.Length == 0)) return;
            if (track == null) _tracks.Add(track = new SourceTrack(_time));
            foreach (var name in names)
                if (_byJoint.Count < MaxJoints && _byJoint.TryAdd(name, track)) track.Joints.Add(name);
            track.Add(receivedAt, age);
        }
    }

    /// <summary>Gets the active sources with the ages of their recent samples.</summary>
    public IReadOnlyList<(string[] Names, double RateHz, TimeSpan[] SortedAges)> Read() => Read(_time.GetTimestamp());

    internal IReadOnlyList<(string[] Names, double RateHz, TimeSpan[] SortedAges)> Read(long now)
    {
        (string[] Names, (long At, TimeSpan Age)[] Samples)[] copies;
        // Copies the samples under the lock and sorts them outside, so that publishers do not wait for the sorting.
        lock (_lock)
        {
            Forget(now);
            copies = [.. _tracks.Select(track => (track.Joints.ToArray(), track.Recent(now)))];
        }

        return [.. copies.Select(copy => (copy.Names, RateHz(copy.Samples, now), copy.Samples.Select(sample => sample.Age).Order().ToArray()))];
    }

    // Finds the source of these joints. Merges sources if the message has joints of several.
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
        foreach (var track in _tracks.Where(track => _time.GetElapsedTime(track.Newest, now) > ForgottenAfter).ToArray())
        {
            _tracks.Remove(track);
            foreach (var joint in track.Joints) _byJoint.Remove(joint);
        }
    }

    double RateHz((long At, TimeSpan Age)[] samples, long now)
    {
        if (samples.Length < 2) return 0;
        // Divides by the time until now, so that the rate of a source that has stopped decreases until the source is removed.
        var (first, last) = (samples.Min(sample => sample.At), samples.Max(sample => sample.At));
        return (samples.Length - 1) / Math.Max(1e-6, _time.GetElapsedTime(first, Math.Max(now, last)).TotalSeconds);
    }
}
