namespace Nowpose.Cli.Figures.Swing;

/// <summary>The swing's frames for Figs 16 to 18.</summary>
/// <param name="Standard">The frames that the figures show and judge, by predictor.</param>
/// <param name="All">All frames, sorted by scenario, then by predictor; at least those of <paramref name="Standard"/>.</param>
sealed record SwingSet(IReadOnlyList<SwingFrames> Standard, IReadOnlyList<SwingFrames> All)
{
    public YoubotSwing Swing => Standard[0].Swing;

    /// <summary>Names of the predictors of <see cref="Standard"/>.</summary>
    public IReadOnlyList<string> Predicted { get; } = [.. Standard.Select(frames => frames.Predictor)];
}
