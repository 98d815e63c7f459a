using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>What one predictor showed of the swing, phase by phase.</summary>
sealed record SwingFrames(string Predictor, IReadOnlyList<StudyFrame[]> Phases)
{
    /// <summary>One run, the same for all predictors, for what is drawn.</summary>
    public StudyFrame[] Shown => Phases[0];

    /// <summary>RMS error of the tool centre point, mm, over the frames of all phases that satisfy a condition on the time.</summary>
    public double RmsMm(YoubotSwing swing, Func<double, bool> when) => Rms(swing, when, f => f.Predicted);

    /// <inheritdoc cref="RmsMm"/>
    public double HoldRmsMm(YoubotSwing swing, Func<double, bool> when) => Rms(swing, when, f => f.Held);

    double Rms(YoubotSwing swing, Func<double, bool> when, Func<StudyFrame, double> shown) => Math.Sqrt(
        Phases.SelectMany(p => p).Where(f => when(f.Time)).Average(f => Math.Pow(swing.GapMm(shown(f), f.Truth), 2)));
}
