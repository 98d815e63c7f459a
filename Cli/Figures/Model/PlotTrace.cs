namespace Nowpose.Cli.Figures.Model;

/// <summary>One line or path of a plot.</summary>
/// <param name="Look">Name of the line style; see <see cref="Looks"/>.</param>
/// <param name="Y">Values, as many as x. Null leaves a gap.</param>
sealed record PlotTrace(string Label, string Look, IReadOnlyList<double> X, IReadOnlyList<double?> Y)
{
    /// <summary>Whether each value is held until the next.</summary>
    public bool Stepped { get; init; }

    /// <summary>Whether each point is marked.</summary>
    public bool Marked { get; init; }

    /// <summary>Whether only points are drawn, without a line. x must be strictly increasing in this case, too.</summary>
    public bool Scattered { get; init; }

    /// <summary>Half length of the error bar at each point; null for none.</summary>
    public IReadOnlyList<double?> Deviation { get; init; }
}
