using Nowpose.Cli.Figures.Swing;

namespace Nowpose.Cli.Demo.Paper;

/// <summary>The measured values for Figs 16 to 18 over all whole swings of a run.</summary>
/// <param name="ErrorRatio">RMS error with compensation divided by the RMS error without it, over all frames of the swings.</param>
/// <param name="SteadyRatio">RMS error at constant velocity divided by the RMS error where the velocity changes.</param>
/// <param name="GapRatios">Gap with compensation divided by the gap without it, at A, B and C.</param>
/// <param name="Reduction">1 minus the ratio of the RMS errors with and without compensation, for t &lt; 1.5 s.</param>
/// <param name="LatencyRatio">Median effective latency e/v with compensation divided by the median without it, for t &lt; 1.5 s.</param>
sealed record PaperSwings(double ErrorRatio, double SteadyRatio, IReadOnlyList<double> GapRatios, double Reduction, double LatencyRatio)
{
    /// <param name="swings">The swings; null if there are none.</param>
    /// <returns>The values; null without swings.</returns>
    public static PaperSwings Of(SwingFrames swings) => swings == null ? null : new(
        swings.ErrorRatio, swings.SteadyRmsMm / swings.CurvedRmsMm, swings.GapRatios,
        1 - swings.RmsMm(Figure18.IsWithin) / swings.HoldRmsMm(Figure18.IsWithin), swings.LatencyMs / swings.HoldLatencyMs);
}
