using Nowpose.Cli.Figures.Swing;
using Nowpose.Studies;

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
        swings.ErrorRatio, swings.SteadyRmsMm / swings.CurvedRmsMm, GapRatiosOf(swings),
        1 - swings.RmsMm(Figure18.IsWithin) / swings.HoldRmsMm(Figure18.IsWithin),
        LatencyMs(swings, frame => frame.Predicted) / LatencyMs(swings, frame => frame.Held));

    static double[] GapRatiosOf(SwingFrames swings)
    {
        var swing = swings.Swing;
        StudyFrame[][] moments = [.. swings.Phases.Select(phase => SwingMoment.Of(swing, phase).Select(moment => phase[moment.Index]).ToArray())];
        double Square(StudyFrame frame, double shown) => Math.Pow(swing.GapMm(shown, frame.Truth), 2);
        return [.. Enumerable.Range(0, moments[0].Length).Select(m => Math.Sqrt(
            moments.Sum(at => Square(at[m], at[m].Predicted)) / moments.Sum(at => Square(at[m], at[m].Held))))];
    }

    static double LatencyMs(SwingFrames swings, Func<StudyFrame, double> shown)
    {
        var swing = swings.Swing;
        return Quantile.Of(
            swings.Phases.SelectMany(phase => phase)
                .Where(f => Figure18.IsWithin(f.Time) && swing.ToolSpeedAt(f.Time) >= Figure18.SlowestShare * swing.FullSpeed)
                .Select(f => 1000 * swing.GapMm(shown(f), f.Truth) / swing.ToolSpeedAt(f.Time)), 0.5);
    }
}
