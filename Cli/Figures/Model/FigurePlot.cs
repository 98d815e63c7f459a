namespace Nowpose.Cli.Figures.Model;

/// <summary>One plot of a figure.</summary>
/// <param name="Title">Name of the plot; unique within the figure.</param>
/// <param name="X">The horizontal axis.</param>
/// <param name="Y">The vertical axis. Its unit applies to all traces.</param>
sealed record FigurePlot(string Title, FigureColumn X, FigureColumn Y, IReadOnlyList<PlotTrace> Traces)
{
    /// <summary>Whether the vertical axis starts at 0.</summary>
    public bool FromZero { get; init; }

    /// <summary>Fixed range of the vertical axis, even if values exceed it; null to fit the values.</summary>
    public (double From, double To)? YRange { get; init; }

    /// <summary>
    /// Values in mm for which curves of constant x·y/1000 are drawn and labelled. If not null, the plot shows operating points instead of
    /// lines.
    /// </summary>
    public IReadOnlyList<double> IsoMm { get; init; }

    /// <summary>Labelled vertical lines.</summary>
    public IReadOnlyList<PlotMark> Marks { get; init; } = [];
}
