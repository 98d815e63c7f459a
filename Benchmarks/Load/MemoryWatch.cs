namespace Nowpose.Benchmarks.Load;

/// <summary>The gateway's memory, second by second.</summary>
sealed class MemoryWatch
{
    const double Mebibyte = 1024 * 1024;

    /// <summary>Of so many seconds the mean is taken: a collection of garbage is no leak.</summary>
    const int Window = 10;

    readonly List<long> _bytes = [];

    public void Add(long bytes) => _bytes.Add(bytes);

    public double MeanMiB => _bytes.Count == 0 ? 0 : _bytes.Average() / Mebibyte;

    public double GreatestMiB => _bytes.Count == 0 ? 0 : _bytes.Max() / Mebibyte;

    /// <summary>How far the mean of ten seconds is from the mean of all at most, as a share of it.</summary>
    public double Deviation =>
        _bytes.Count == 0 ? 0 : _bytes.Chunk(Window).Where(chunk => chunk.Length == Window || _bytes.Count < Window)
            .Max(chunk => Math.Abs((chunk.Average() / _bytes.Average()) - 1));
}
