namespace Nowpose.Benchmarks.Load;

/// <summary>Samples the gateway's memory every second.</summary>
sealed class MemoryWatch
{
    const double Mebibyte = 1024 * 1024;

    /// <summary>Duration over which samples are averaged, s, so that garbage collections do not look like leaks.</summary>
    const int Window = 10;

    readonly List<long> _bytes = [];

    public void Add(long bytes) => _bytes.Add(bytes);

    public double MeanMiB => _bytes.Count == 0 ? 0 : _bytes.Average() / Mebibyte;

    public double MaxMiB => _bytes.Count == 0 ? 0 : _bytes.Max() / Mebibyte;

    /// <summary>Maximum deviation of a ten-second mean from the mean of all samples, as a share of the mean.</summary>
    public double Deviation =>
        _bytes.Count == 0 ? 0 : _bytes.Chunk(Window).Where(chunk => chunk.Length == Window || _bytes.Count < Window)
            .Max(chunk => Math.Abs((chunk.Average() / _bytes.Average()) - 1));
}
