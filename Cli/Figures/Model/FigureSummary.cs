namespace Nowpose.Cli.Figures.Model;

/// <summary>A small table for reading, its first column naming the rows.</summary>
/// <param name="Columns">Of all columns, the first included.</param>
sealed record FigureSummary(string Caption, IReadOnlyList<string> Columns, IReadOnlyList<IReadOnlyList<string>> Rows);
