namespace Nowpose.Cli.Figures.Model;

/// <summary>A small table for readers. Its first column contains the names of the rows.</summary>
/// <param name="Columns">Names of all columns, including the first one.</param>
sealed record FigureSummary(string Caption, IReadOnlyList<string> Columns, IReadOnlyList<IReadOnlyList<string>> Rows);
