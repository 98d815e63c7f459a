namespace Nowpose.Cli.Figures.Field;

/// <summary>Mean errors, mm, of an axis that moves at constant velocity.</summary>
/// <param name="FreshMm">Of hold when every frame has a sample just sent.</param>
/// <param name="SampledMm">Of hold at the paper's T_s.</param>
/// <param name="PredictedMm">By predictor, at the paper's T_s.</param>
sealed record FieldPoint(double SpeedMmPerS, double LatencyMs, double FreshMm, double SampledMm, IReadOnlyList<double> PredictedMm)
{
    /// <summary>e = v·L, mm.</summary>
    public double FormulaMm => SpeedMmPerS * LatencyMs / 1000;
}
