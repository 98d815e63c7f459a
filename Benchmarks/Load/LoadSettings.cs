namespace Nowpose.Benchmarks.Load;

/// <summary>The load on a gateway.</summary>
sealed record LoadSettings(int Headsets, double RateHz, TimeSpan Length)
{
    /// <summary>Time that is not measured: connections settle, code is compiled, and the gateway's memory reaches its size.</summary>
    public TimeSpan WarmUp { get; init; } = TimeSpan.FromSeconds(10);
}
