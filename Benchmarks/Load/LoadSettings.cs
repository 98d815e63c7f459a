namespace Nowpose.Benchmarks.Load;

/// <summary>Settings of the load on a gateway.</summary>
sealed record LoadSettings(int Headsets, double RateHz, TimeSpan Length)
{
    /// <summary>Time before the measurement in which connections settle, code is compiled and the gateway's memory reaches its final size.</summary>
    public TimeSpan WarmUp { get; init; } = TimeSpan.FromSeconds(10);
}
