using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The frames of the swing as shown by one predictor.</summary>
/// <param name="Phases">The frames of each run; times are in seconds since the start of the swing.</param>
sealed record SwingFrames(string Predictor, SwingScenario Scenario, YoubotSwing Swing, IReadOnlyList<StudyFrame[]> Phases)
{
    /// <summary>The run that is drawn, the same for all predictors.</summary>
    public StudyFrame[] Shown => Phases[0];

    /// <summary>Gets the RMS error of the tool centre point, mm, over the frames of all runs that satisfy a condition on the time.</summary>
    public double RmsMm(Func<double, bool> when) => Rms(when, f => f.Predicted);

    /// <inheritdoc cref="RmsMm"/>
    public double HoldRmsMm(Func<double, bool> when) => Rms(when, f => f.Held);

    /// <summary>RMS error with compensation divided by that without, over all frames. It includes the overshoot after a stop.</summary>
    public double ErrorRatio => RmsMm(_ => true) / HoldRmsMm(_ => true);

    /// <summary>RMS error where the velocity has been constant for the time span of a prediction, mm.</summary>
    public double SteadyRmsMm => RmsMm(Swing.IsSteadyAt);

    /// <summary>RMS error where the velocity changes within the time span of a prediction, mm.</summary>
    public double CurvedRmsMm => RmsMm(Swing.IsCurvedAt);

    /// <summary>Gap with compensation divided by that without, at each of the <see cref="SwingMoment"/>s, RMS over all runs.</summary>
    public IReadOnlyList<double> GapRatios
    {
        get
        {
            StudyFrame[][] moments = [.. Phases.Select(phase => SwingMoment.Of(Swing, phase).Select(moment => phase[moment.Index]).ToArray())];
            double Square(StudyFrame frame, double shown) => Math.Pow(Swing.GapMm(shown, frame.Truth), 2);
            return [.. Enumerable.Range(0, moments[0].Length).Select(m => Math.Sqrt(
                moments.Sum(at => Square(at[m], at[m].Predicted)) / moments.Sum(at => Square(at[m], at[m].Held))))];
        }
    }

    /// <summary>Median of the effective latency e/v over the frames of all runs that Fig. 18 shows, ms.</summary>
    public double LatencyMs => Latency(f => f.Predicted);

    /// <inheritdoc cref="LatencyMs"/>
    public double HoldLatencyMs => Latency(f => f.Held);

    double Latency(Func<StudyFrame, double> shown) => Quantile.Of(
        Phases.SelectMany(p => p).Where(f => Figure18.IsShown(Swing, f.Time))
            .Select(f => 1000 * Swing.GapMm(shown(f), f.Truth) / Swing.ToolSpeedAt(f.Time)), 0.5);

    double Rms(Func<double, bool> when, Func<StudyFrame, double> shown) => Math.Sqrt(
        Phases.SelectMany(p => p).Where(f => when(f.Time)).Average(f => Math.Pow(Swing.GapMm(shown(f), f.Truth), 2)));
}
