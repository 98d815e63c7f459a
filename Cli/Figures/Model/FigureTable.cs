using System.Globalization;

namespace Nowpose.Cli.Figures.Model;

/// <summary>The data of a figure as rows of numbers.</summary>
sealed class FigureTable(params FigureColumn[] columns)
{
    readonly List<double?[]> _rows = [];

    public IReadOnlyList<FigureColumn> Columns { get; } = columns;

    public IReadOnlyList<IReadOnlyList<double?>> Rows => _rows;

    /// <param name="values">One value per column. A missing value is null, not NaN.</param>
    public void Add(params double?[] values)
    {
        if (values.Length != Columns.Count) throw new ArgumentException(FigureErrors.ValueCount(values.Length, Columns.Count), nameof(values));
        if (Array.FindIndex(values, v => v is double x && !double.IsFinite(x)) is >= 0 and var bad)
            throw new ArgumentException(FigureErrors.NotFinite(Columns[bad].Header, _rows.Count + 1, values[bad]), nameof(values));
        _rows.Add(values);
    }

    /// <summary>Gets two columns as a trace of a plot. Skips rows without a value for x.</summary>
    public PlotTrace Trace(string label, string look, int x, int y)
    {
        var rows = _rows.Where(row => row[x] != null).ToArray();
        return new PlotTrace(label, look, [.. rows.Select(row => row[x].Value)], [.. rows.Select(row => row[y])]);
    }

    /// <summary>Writes a header with units, then one line per row. Numbers have a decimal point and at most six decimals.</summary>
    public void WriteCsv(TextWriter writer)
    {
        writer.Write(string.Join(',', Columns.Select(c => c.Header)) + "\n");
        foreach (var row in _rows) writer.Write(string.Join(',', row.Select(Text)) + "\n");
    }

    static string Text(double? value) => value?.ToString("0.######", CultureInfo.InvariantCulture) ?? "";
}
