using Nowpose.Cli.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The displayed frames of the swing for one predictor.</summary>
/// <param name="Phases">Frames of each run. Their times are in seconds since the start of the swing.</param>
sealed record SwingFrames(string Predictor, SwingScenario Scenario, YoubotSwing Swing, IReadOnlyList<StudyFrame[]> Phases)
{
    /// <summary>Frames of the run that is drawn. It is the same run for all predictors.</summary>
    public StudyFrame[] Shown => Phases[0];

    /// <summary>Gets the RMS error of the tool centre point over the frames of all runs whose time satisfies a condition, mm.</summary>
    public double RmsMm(Func<double, bool> when) => Rms(when, f => f.Predicted);

    /// <summary>Gets the RMS error without compensation over the frames of all runs whose time satisfies a condition, mm.</summary>
    public double HoldRmsMm(Func<double, bool> when) => Rms(when, f => f.Held);

    /// <summary>RMS error with compensation divided by the RMS error without it, over all frames, including the overshoot after each stop.</summary>
    public double ErrorRatio => RmsMm(_ => true) / HoldRmsMm(_ => true);

    /// <summary>RMS error while the velocity has been constant for at least the time span of a prediction, mm.</summary>
    public double SteadyRmsMm => RmsMm(Swing.IsSteadyAt);

    /// <summary>RMS error while the velocity has changed within the time span of a prediction, mm.</summary>
    public double CurvedRmsMm => RmsMm(Swing.IsCurvedAt);

    /// <summary>RMS gap over all runs with compensation divided by the RMS gap without it, at each <see cref="SwingMoment"/>.</summary>
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

    /// <summary>Median effective latency e/v over the frames that Fig. 18 shows, in all runs, ms.</summary>
    public double LatencyMs => Latency(f => f.Predicted);

    /// <summary>Median effective latency e/v without compensation over the frames that Fig. 18 shows, in all runs, ms.</summary>
    public double HoldLatencyMs => Latency(f => f.Held);

    double Latency(Func<StudyFrame, double> shown) => Quantile.Of(
        Phases.SelectMany(p => p).Where(f => Figure18.IsShown(Swing, f.Time))
            .Select(f => 1000 * Swing.GapMm(shown(f), f.Truth) / Swing.ToolSpeedAt(f.Time)), 0.5);

    double Rms(Func<double, bool> when, Func<StudyFrame, double> shown) => Math.Sqrt(
        Phases.SelectMany(p => p).Where(f => when(f.Time)).Average(f => Math.Pow(Swing.GapMm(shown(f), f.Truth), 2)));
}
