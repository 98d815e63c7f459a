namespace Nowpose.Cli.Figures.Model;

/// <summary>One line, or one set of points, in a plot.</summary>
/// <param name="Look">Name of the line style; see <see cref="Looks"/>.</param>
/// <param name="Y">Values, one per value of x. Null leaves a gap.</param>
sealed record PlotTrace(string Label, string Look, IReadOnlyList<double> X, IReadOnlyList<double?> Y)
{
    /// <summary>Whether each value is held until the next one.</summary>
    public bool Stepped { get; init; }

    /// <summary>Whether each point has a marker.</summary>
    public bool Marked { get; init; }

    /// <summary>Whether the points are drawn without a line. The values of x must be strictly increasing in this case, too.</summary>
    public bool Scattered { get; init; }

    /// <summary>Half the length of the error bar at each point; null for no error bars.</summary>
    public IReadOnlyList<double?> Deviation { get; init; }
}
