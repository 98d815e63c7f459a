namespace Nowpose.Cli.Figures.Field;

/// <summary>Mean errors, mm, of an axis that moves at constant velocity.</summary>
/// <param name="FreshMm">Error of hold if each frame has a new sample.</param>
/// <param name="SampledMm">Error of hold at the paper's T_s.</param>
/// <param name="PredictedMm">Error of each predictor at the paper's T_s.</param>
sealed record FieldPoint(double SpeedMmPerS, double LatencyMs, double FreshMm, double SampledMm, IReadOnlyList<double> PredictedMm)
{
    /// <summary>Error by the paper's formula e = v·L, mm.</summary>
    public double FormulaMm => SpeedMmPerS * LatencyMs / 1000;
}
