namespace Nowpose.Cli.Figures.Swing;

/// <summary>The swing's frames for Figs 16 to 18.</summary>
/// <param name="Standard">Frames that the figures show and judge; one entry per predictor.</param>
/// <param name="All">Frames of all scenarios, sorted by scenario and then by predictor. Includes <paramref name="Standard"/>.</param>
sealed record SwingSet(IReadOnlyList<SwingFrames> Standard, IReadOnlyList<SwingFrames> All)
{
    public YoubotSwing Swing => Standard[0].Swing;

    /// <summary>Names of the predictors in <see cref="Standard"/>.</summary>
    public IReadOnlyList<string> Predicted { get; } = [.. Standard.Select(frames => frames.Predictor)];
}
