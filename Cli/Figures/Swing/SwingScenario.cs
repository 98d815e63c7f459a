namespace Nowpose.Cli.Figures.Swing;

/// <summary>Defines whether the headset has received other motion before the swing.</summary>
/// <param name="IsCold">Whether the swing is the first motion that the headset receives. If not, a few shorter moves precede it.</param>
sealed record SwingScenario(string Name, bool IsCold)
{
    /// <summary>The scenario that the figures show and judge.</summary>
    public static readonly SwingScenario Standard = new("after other moves", IsCold: false);

    public static readonly SwingScenario Cold = new(Figure16Texts.FirstMove, IsCold: true);

    /// <summary>Rest before the first move, s. The clock has settled when the swing begins, more than 11 s after the start.</summary>
    double Rest => IsCold ? 11 : 6;

    /// <param name="delay">Additional rest before the first move, s.</param>
    public YoubotSwing SwingAfter(double delay) => new(IsCold, Rest + delay);
}
