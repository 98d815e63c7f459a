namespace Nowpose.Benchmarks.Load;

/// <summary>Limits for the gateway under load.</summary>
static class LoadLimits
{
    public static readonly TimeSpan ForwardingP99 = TimeSpan.FromMilliseconds(5);
    public static readonly TimeSpan SyncErrorP95 = TimeSpan.FromMilliseconds(1);

    /// <summary>Maximum deviation of the gateway's memory from its mean after the warm-up, as a share of the mean.</summary>
    public const double MemoryDeviation = 0.05;
}
