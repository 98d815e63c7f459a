namespace Nowpose.Cli.Figures.Model;

/// <summary>One plot of a figure.</summary>
/// <param name="Title">Name of the plot, unique in the figure.</param>
/// <param name="X">The horizontal axis.</param>
/// <param name="Y">The vertical axis; all traces have its unit.</param>
sealed record FigurePlot(string Title, FigureColumn X, FigureColumn Y, IReadOnlyList<PlotTrace> Traces)
{
    /// <summary>Whether the vertical axis begins at 0.</summary>
    public bool FromZero { get; init; }

    /// <summary>Range of the vertical axis, even if data exceed it; null to fit the data.</summary>
    public (double From, double To)? YRange { get; init; }

    /// <summary>Curves of equal product x·y/1000, labelled with their values in mm. Makes this a plot of operating points. Null for lines.</summary>
    public IReadOnlyList<double> IsoMm { get; init; }

    /// <summary>Vertical lines with a label at a value of x.</summary>
    public IReadOnlyList<PlotMark> Marks { get; init; } = [];
}
