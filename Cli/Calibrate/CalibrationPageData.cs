using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Calibrate;

/// <summary>The content of calibration.html for one calibration.</summary>
/// <param name="Title">Name of the measuring method.</param>
/// <param name="Result">The outcome in one sentence.</param>
/// <param name="Facts">Pairs of name and value; the numbers of the profile come first.</param>
sealed record CalibrationPageData(string Title, string Result, IReadOnlyList<string[]> Facts)
{
    /// <summary>Warnings that a reader must consider before using the result; empty if there are none.</summary>
    public IReadOnlyList<string> Warnings { get; init; } = [];

    public IReadOnlyList<CalibrationSection> Sections { get; init; } = [];

    /// <summary>Returns the page with another warning before the present ones.</summary>
    public CalibrationPageData WithWarning(string warning) => this with { Warnings = [warning, .. Warnings] };
}

/// <summary>A section of the page: one or more plots with an explanation and a table.</summary>
/// <param name="Heading">The heading, for example "Render time and L_visu over pictures".</param>
/// <param name="Source">Figure or section of the paper, for example "Fig. 10"; null if there is none.</param>
/// <param name="Words">Explanation of the plots.</param>
sealed record CalibrationSection(string Heading, string Source, string Words, IReadOnlyList<FigurePlot> Plots, FigureTable Table = null);
