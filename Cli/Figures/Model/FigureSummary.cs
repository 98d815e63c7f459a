namespace Nowpose.Cli.Figures.Model;

/// <summary>A small table for readers. Its first column names the rows.</summary>
/// <param name="Columns">Names of all columns, including the first.</param>
sealed record FigureSummary(string Caption, IReadOnlyList<string> Columns, IReadOnlyList<IReadOnlyList<string>> Rows);
