using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The swing in each scenario by each compared predictor.</summary>
sealed class SwingRuns
{
    /// <summary>Time shown before the swing starts, s.</summary>
    const double Before = 0.2;

    static readonly SwingScenario[] Scenarios = [SwingScenario.Standard, SwingScenario.Realisation, SwingScenario.Cold];

    readonly SwingFrames[,] _frames = new SwingFrames[Scenarios.Length, Predicted.Count];

    public SwingRuns(FigureSettings settings) => Work = [.. from s in Enumerable.Range(0, Scenarios.Length)
        from p in Enumerable.Range(0, Predicted.Count)
        select (Action)(() => _frames[s, p] = Play(Scenarios[s], settings.Study, Predicted[p]))];

    /// <summary>The paper's predictor first, then ours.</summary>
    public static IReadOnlyList<string> Predicted { get; } = ["quadratic", .. FigureSettings.OurPredictors];

    public YoubotSwing Swing { get; } = new(isCold: false);

    public IReadOnlyList<Action> Work { get; }

    /// <summary>The frames under the conditions of all figures, by predictor.</summary>
    public IReadOnlyList<SwingFrames> Standard => [.. Predicted.Select((_, p) => _frames[0, p])];

    /// <summary>The frames under the conditions of the paper's realisation, by predictor.</summary>
    public IReadOnlyList<SwingFrames> Realisation => [.. Predicted.Select((_, p) => _frames[1, p])];

    /// <summary>All frames, sorted by scenario, then by predictor.</summary>
    public IEnumerable<SwingFrames> All => _frames.Cast<SwingFrames>();

    SwingFrames Play(SwingScenario scenario, StudySettings study, string predictor)
    {
        var swing = scenario.IsCold ? new YoubotSwing(isCold: true) : Swing;
        var conditions = scenario.With(study) with { WarmUp = swing.Start - Before };
        return new SwingFrames(predictor, scenario, swing, [.. Enumerable.Range(0, study.Phases).Select(phase => PredictionStudy
            .Frames(swing.Motion, conditions, FigureSettings.Predictor(predictor), phase)
            .Select(frame => frame with { Time = frame.Time - swing.Start }).ToArray())]);
    }
}
