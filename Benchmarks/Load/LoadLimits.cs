namespace Nowpose.Benchmarks.Load;

/// <summary>The limits that the gateway must keep.</summary>
static class LoadLimits
{
    public static readonly TimeSpan ForwardingP99 = TimeSpan.FromMilliseconds(5);
    public static readonly TimeSpan SyncErrorP95 = TimeSpan.FromMilliseconds(1);

    /// <summary>Maximum deviation of the gateway's memory from its mean after the warm-up.</summary>
    public const double MemoryDeviation = 0.05;
}
