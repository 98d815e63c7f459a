namespace Nowpose.Cli.Figures.Model;

/// <summary>One line or path of a plot.</summary>
/// <param name="Look">How it looks; see <see cref="Looks"/>.</param>
/// <param name="Y">As many as x; null leaves a gap.</param>
sealed record PlotTrace(string Label, string Look, IReadOnlyList<double> X, IReadOnlyList<double?> Y)
{
    /// <summary>Holds each value until the next.</summary>
    public bool Stepped { get; init; }

    /// <summary>Marks each point.</summary>
    public bool Marked { get; init; }

    /// <summary>Points only, no line between them; x must increase strictly all the same.</summary>
    public bool Scattered { get; init; }

    /// <summary>Half length of a bar across each point; null for none.</summary>
    public IReadOnlyList<double?> Deviation { get; init; }
}
