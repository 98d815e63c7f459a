using Nowpose.Sync;

namespace Nowpose.Cli.Figures.Clocks;

/// <summary>The quantities of Fig. 8 after one sync exchange. Offsets are relative to Φ* of the first exchange.</summary>
/// <param name="Seconds">Headset time at the end of the exchange, relative to the end of the first exchange.</param>
/// <param name="OffsetMs">Φ* of this exchange alone, Eq. (5).</param>
/// <param name="FitMs">Estimate of Φ at the end of the exchange, (γ₂−1)·t + Θ₂; null before the first estimate.</param>
/// <param name="SkewPpm">Estimate of γ₂−1, ppm.</param>
/// <param name="InterceptMs">Θ₂, the estimate of Φ at the first exchange.</param>
/// <param name="RoundTripMs">RTT as defined in the paper: from sending the request to receiving the reply.</param>
readonly record struct SyncStep(double Seconds, double OffsetMs, double? FitMs, double? SkewPpm, double? InterceptMs, double RoundTripMs)
{
    /// <summary>The exchange with its four timestamps.</summary>
    public SyncExchange Exchange { get; init; }

    /// <summary>Headset time at the end of the exchange.</summary>
    public HeadsetTime At => Exchange.T4;

    /// <summary>ε of Eq. (6): Φ* minus the estimate, ms; null before the first estimate.</summary>
    public double? FitErrorMs => OffsetMs - FitMs;
}
