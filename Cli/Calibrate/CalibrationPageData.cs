using Nowpose.Cli.Figures.Model;

namespace Nowpose.Cli.Calibrate;

/// <summary>What calibration.html shows of one calibration.</summary>
/// <param name="Title">Names the way of measuring.</param>
/// <param name="Result">The outcome in one sentence.</param>
/// <param name="Facts">Name and value, the numbers of the profile first.</param>
sealed record CalibrationPageData(string Title, string Result, IReadOnlyList<string[]> Facts)
{
    /// <summary>What a user must know before trusting it; empty when nothing is wrong.</summary>
    public IReadOnlyList<string> Warnings { get; init; } = [];

    public IReadOnlyList<CalibrationSection> Sections { get; init; } = [];
}

/// <summary>One plot or more with the words and numbers to them.</summary>
/// <param name="Heading">"Render time and L_visu over pictures".</param>
/// <param name="Source">Figure or section of the paper, as "Fig. 10"; null where it has none.</param>
/// <param name="Words">What is seen.</param>
sealed record CalibrationSection(string Heading, string Source, string Words, IReadOnlyList<FigurePlot> Plots, FigureTable Table = null);
