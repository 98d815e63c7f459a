using Nowpose.Studies;

namespace Nowpose.Cli.Figures.Swing;

/// <summary>The swing under both scenarios by every predictor of interest.</summary>
sealed class SwingRuns
{
    static readonly SwingScenario[] Scenarios = [SwingScenario.Standard, SwingScenario.Realisation];

    readonly StudyFrame[,][][] _frames;

    public SwingRuns(FigureSettings settings)
    {
        _frames = new StudyFrame[Scenarios.Length, Predicted.Count][][];
        Work = [.. from s in Enumerable.Range(0, Scenarios.Length) from p in Enumerable.Range(0, Predicted.Count)
            select (Action)(() => _frames[s, p] = Play(Scenarios[s].Study(settings), Predicted[p]))];
    }

    /// <summary>The paper's predictor first, then ours.</summary>
    public static IReadOnlyList<string> Predicted { get; } = ["quadratic", .. FigureSettings.OurPredictors];

    public YoubotSwing Swing { get; } = new();

    public IReadOnlyList<Action> Work { get; }

    /// <summary>Under the conditions of all figures, by predictor.</summary>
    public IReadOnlyList<SwingFrames> Standard => Of(0);

    /// <summary>Under the conditions of the paper's realisation, by predictor.</summary>
    public IReadOnlyList<SwingFrames> Realisation => Of(1);

    SwingFrames[] Of(int scenario) => [.. Predicted.Select((name, p) => new SwingFrames(name, _frames[scenario, p]))];

    StudyFrame[][] Play(StudySettings study, string predictor) => [.. Enumerable.Range(0, study.Phases)
        .Select(phase => PredictionStudy.Frames(Swing.Motion, study, FigureSettings.Predictor(predictor), phase)
            // Before the first sample there is nothing to show.
            .SkipWhile(frame => frame.NewestSample < 0).ToArray())];
}
