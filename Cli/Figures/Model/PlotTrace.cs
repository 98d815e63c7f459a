namespace Nowpose.Cli.Figures.Model;

/// <summary>One line, or one set of points, in a plot.</summary>
/// <param name="Look">Name of the line style; see <see cref="Looks"/>.</param>
/// <param name="Y">Values, one per value of x. Null leaves a gap.</param>
sealed record PlotTrace(string Label, string Look, IReadOnlyList<double> X, IReadOnlyList<double?> Y)
{
    /// <summary>Minimum distance between the values of x of two points, which is one unit of the last digit in the page.</summary>
    const double Step = 1e-4;

    /// <summary>
    /// Creates a trace of points without a line, in any order. Points with equal values of x are moved apart, because the page joins traces by these values.
    /// </summary>
    public static PlotTrace Points(string label, string look, IEnumerable<(double X, double Y)> points)
    {
        (double X, double Y)[] sorted = [.. points.OrderBy(point => point.X)];
        var x = new double[sorted.Length];
        for (var i = 0; i < x.Length; i++) x[i] = Math.Max(Math.Round(sorted[i].X, 4), i == 0 ? double.MinValue : x[i - 1] + Step);
        return new(label, look, x, [.. sorted.Select(point => (double?)point.Y)]) { Scattered = true };
    }

    /// <summary>Whether each value is held until the next one.</summary>
    public bool Stepped { get; init; }

    /// <summary>Whether each point has a marker.</summary>
    public bool Marked { get; init; }

    /// <summary>Whether the points are drawn without a line. The values of x must be strictly increasing in this case, too.</summary>
    public bool Scattered { get; init; }

    /// <summary>Half the length of the error bar at each point; null for no error bars.</summary>
    public IReadOnlyList<double?> Deviation { get; init; }
}
