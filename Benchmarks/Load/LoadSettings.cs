namespace Nowpose.Benchmarks.Load;

/// <summary>What a gateway is put under.</summary>
sealed record LoadSettings(int Headsets, double RateHz, TimeSpan Length)
{
    /// <summary>Not measured: connections settle, code is compiled, the gateway's memory finds its size.</summary>
    public TimeSpan WarmUp { get; init; } = TimeSpan.FromSeconds(10);
}
