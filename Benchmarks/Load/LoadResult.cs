namespace Nowpose.Benchmarks.Load;

/// <summary>The measured values of a gateway under load.</summary>
sealed record LoadResult(
    int Headsets, double RateHz, double Seconds, long Messages, double MessagesPerSecond, long Lost, int Ended, long Refused,
    double ForwardP50Ms, double ForwardP99Ms, double ForwardMaxMs, double SyncErrorP50Us, double SyncErrorP95Us, double TruthBoundUs,
    double MemoryMeanMib, double MemoryMaxMib, double MemoryDeviation, double GatewayCores, double ToolCores)
{
    /// <summary>Name of the limit that the gateway exceeds; null if it meets all limits.</summary>
    public string Break =>
        ForwardP99Ms >= LoadLimits.ForwardingP99.TotalMilliseconds ? "forwarding P99"
        : Lost > 0 ? "lost samples"
        : Ended > 0 ? "ended connections"
        : null;

    public bool IsSyncGood => SyncErrorP95Us < LoadLimits.SyncErrorP95.TotalMicroseconds;

    public bool IsMemoryFlat => MemoryDeviation <= LoadLimits.MemoryDeviation;
}
