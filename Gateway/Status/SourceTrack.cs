namespace Nowpose.Gateway.Status;

/// <summary>The receipt times and ages of the newest messages of one source.</summary>
sealed class SourceTrack(TimeProvider time)
{
    readonly RecentTimes _ages = new(512, TimeSpan.FromSeconds(5), time);

    /// <summary>The joints, in the order in which they were first received.</summary>
    public List<string> Joints { get; } = [];

    public long Newest { get; private set; }

    public void Add(long at, TimeSpan age)
    {
        Newest = Math.Max(Newest, at);
        _ages.Add(at, age);
    }

    /// <summary>Merges another track into this one.</summary>
    public void Take(SourceTrack other)
    {
        Newest = Math.Max(Newest, other.Newest);
        _ages.Merge(other._ages);
        Joints.AddRange(other.Joints);
    }

    /// <summary>Gets the samples of the last few seconds.</summary>
    public (long At, TimeSpan Age)[] Recent(long now) => [.. _ages.Read(now)];
}
