namespace Nowpose.Benchmarks;

/// <summary>Writes a Markdown table row by row, so that a long measurement shows its results so far.</summary>
sealed class MarkdownTable
{
    readonly TextWriter _to;

    /// <summary>Writes the headings. The first column is left-aligned, the others are right-aligned.</summary>
    public MarkdownTable(TextWriter to, params IEnumerable<string> columns)
    {
        _to = to;
        AddCells(columns);
        AddCells(columns.Select((_, i) => i == 0 ? "---" : "---:"));
    }

    /// <param name="cells">One cell or more each, separated by " | ". Numbers are written with a point.</param>
    public void Add(params FormattableString[] cells) => AddCells(cells.Select(FormattableString.Invariant));

    public void AddCells(IEnumerable<string> cells) => _to.WriteLine($"| {string.Join(" | ", cells)} |");
}
