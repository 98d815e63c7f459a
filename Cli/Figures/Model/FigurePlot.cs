namespace Nowpose.Cli.Figures.Model;

/// <summary>One plot of a figure.</summary>
/// <param name="Title">Names it among the figure's plots.</param>
/// <param name="X">What runs to the right.</param>
/// <param name="Y">What runs up; its unit is that of all traces.</param>
sealed record FigurePlot(string Title, FigureColumn X, FigureColumn Y, IReadOnlyList<PlotTrace> Traces)
{
    /// <summary>The vertical axis begins at 0.</summary>
    public bool FromZero { get; init; }

    /// <summary>The vertical axis is this long both ways, whatever runs out of it; null to follow the data.</summary>
    public double? YExtent { get; init; }

    /// <summary>Curves of equal product x·y/1000, each labelled with its value in mm: makes it a plot of operating points. Null for lines.</summary>
    public IReadOnlyList<double> IsoMm { get; init; }

    /// <summary>Vertical lines with a name at a value of x.</summary>
    public IReadOnlyList<PlotMark> Marks { get; init; } = [];
}
