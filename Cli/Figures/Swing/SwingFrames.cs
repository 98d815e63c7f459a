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

    /// <summary>RMS error with compensation divided by that without, over all frames: also after a stop, where predictions overshoot.</summary>
    public double ErrorRatio => RmsMm(_ => true) / HoldRmsMm(_ => true);

    /// <summary>RMS error where the velocity has been constant for the time span of a prediction, mm.</summary>
    public double SteadyRmsMm => RmsMm(Swing.IsSteadyAt);

    /// <summary>RMS error where the velocity changes within the time span of a prediction, mm.</summary>
    public double CurvedRmsMm => RmsMm(Swing.IsCurvedAt);

    double Rms(Func<double, bool> when, Func<StudyFrame, double> shown) => Math.Sqrt(
        Phases.SelectMany(p => p).Where(f => when(f.Time)).Average(f => Math.Pow(Swing.GapMm(shown(f), f.Truth), 2)));
}
