namespace Nowpose.Gateway.Status;

/// <summary>The receipt times and ages of the newest messages of one source.</summary>
sealed class SourceTrack(TimeProvider time)
{
    const int Remembered = 512;
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly (long At, TimeSpan Age)[] _ring = new (long, TimeSpan)[Remembered];
    int _count, _next;

    /// <summary>The joints, in the order in which they were first received.</summary>
    public List<string> Joints { get; } = [];

    public long Newest { get; private set; }

    public void Add(long at, TimeSpan age)
    {
        Newest = Math.Max(Newest, at);
        _ring[_next] = (at, age);
        _next = (_next + 1) % Remembered;
        _count = Math.Min(_count + 1, Remembered);
    }

    /// <summary>Merges another track into this one.</summary>
    public void Take(SourceTrack other)
    {
        var both = _ring.Take(_count).Concat(other._ring.Take(other._count)).OrderBy(sample => sample.At).TakeLast(Remembered).ToArray();
        _count = _next = 0;
        foreach (var (at, age) in both) Add(at, age);
        Joints.AddRange(other.Joints);
    }

    /// <summary>Gets the samples of the last few seconds.</summary>
    public (long At, TimeSpan Age)[] Recent(long now) =>
        [.. _ring.Take(_count).Where(sample => time.GetElapsedTime(sample.At, now) < Span)];
}
