using Nowpose.Cli.Figures.Swing;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>The numbers of Figs 16 to 18, over all whole swings of a run.</summary>
/// <param name="ErrorRatio">RMS error with compensation divided by that without, over all frames of the swings.</param>
/// <param name="SteadyRatio">RMS error at constant velocity divided by that in the curved phases.</param>
/// <param name="GapRatios">Gap with compensation divided by that without, at A, B and C.</param>
/// <param name="Reduction">1 − RMS with / RMS without compensation for t &lt; 1.5 s.</param>
/// <param name="LatencyRatio">Median of the effective latency e/v with compensation divided by that without, for t &lt; 1.5 s.</param>
sealed record PaperSwings(double ErrorRatio, double SteadyRatio, IReadOnlyList<double> GapRatios, double Reduction, double LatencyRatio)
{
    /// <param name="swings">The swings; null for none.</param>
    /// <returns>Null without a swing.</returns>
    public static PaperSwings Of(SwingFrames swings) => swings == null ? null : new(
        swings.ErrorRatio, swings.SteadyRmsMm / swings.CurvedRmsMm, swings.GapRatios,
        1 - swings.RmsMm(Figure18.IsWithin) / swings.HoldRmsMm(Figure18.IsWithin), swings.LatencyMs / swings.HoldLatencyMs);
}
