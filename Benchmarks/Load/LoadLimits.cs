namespace Nowpose.Benchmarks.Load;

/// <summary>What the gateway is held to.</summary>
static class LoadLimits
{
    public static readonly TimeSpan ForwardingP99 = TimeSpan.FromMilliseconds(5);
    public static readonly TimeSpan SyncErrorP95 = TimeSpan.FromMilliseconds(1);

    /// <summary>Of the gateway's memory from its mean after the warm-up.</summary>
    public const double MemoryDeviation = 0.05;
}
