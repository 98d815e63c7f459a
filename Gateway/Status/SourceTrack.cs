using System.Diagnostics;

namespace Nowpose.Gateway.Status;

/// <summary>One source's newest messages: when they came, and how old they were.</summary>
sealed class SourceTrack
{
    const int Remembered = 512;
    static readonly TimeSpan Span = TimeSpan.FromSeconds(5);

    readonly (long At, TimeSpan Age)[] _ring = new (long, TimeSpan)[Remembered];
    int _count, _next;

    /// <summary>In the order in which they came first.</summary>
    public List<string> Joints { get; } = [];

    public long Newest { get; private set; }

    public void Add(long at, TimeSpan age)
    {
        Newest = Math.Max(Newest, at);
        _ring[_next] = (at, age);
        _next = (_next + 1) % Remembered;
        _count = Math.Min(_count + 1, Remembered);
    }

    /// <summary>Becomes both of them.</summary>
    public void Take(SourceTrack other)
    {
        var both = _ring.Take(_count).Concat(other._ring.Take(other._count)).OrderBy(sample => sample.At).TakeLast(Remembered).ToArray();
        _count = _next = 0;
        foreach (var (at, age) in both) Add(at, age);
        Joints.AddRange(other.Joints);
    }

    /// <summary>The samples of the last seconds.</summary>
    public (long At, TimeSpan Age)[] Recent(long now) =>
        [.. _ring.Take(_count).Where(sample => Stopwatch.GetElapsedTime(sample.At, now) < Span)];
}
