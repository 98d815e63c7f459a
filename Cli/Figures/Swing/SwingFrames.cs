using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>What one predictor showed of the swing.</summary>
/// <param name="Phases">The frames of each run; their times are s since the swing's start.</param>
sealed record SwingFrames(string Predictor, SwingScenario Scenario, YoubotSwing Swing, IReadOnlyList<StudyFrame[]> Phases)
{
    /// <summary>One run, the same for all predictors, for what is drawn.</summary>
    public StudyFrame[] Shown => Phases[0];

    /// <summary>RMS error of the tool centre point, mm, over the frames of all runs that satisfy a condition on the time.</summary>
    public double RmsMm(Func<double, bool> when) => Rms(when, f => f.Predicted);

    /// <inheritdoc cref="RmsMm"/>
    public double HoldRmsMm(Func<double, bool> when) => Rms(when, f => f.Held);

    double Rms(Func<double, bool> when, Func<StudyFrame, double> shown) => Math.Sqrt(
        Phases.SelectMany(p => p).Where(f => when(f.Time)).Average(f => Math.Pow(Swing.GapMm(shown(f), f.Truth), 2)));
}
