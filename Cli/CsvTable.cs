using System.Globalization;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli;

/// <summary>Reads CSV text with named columns, row by row. An error message is one line with file, line and field.</summary>
sealed class CsvTable : IDisposable
{
    /// <summary>Maximum number of characters of a wrong header in a message. A file of another format can have a very long first line.</summary>
    const int MaxShown = 120;

    readonly string _path;
    readonly CsvRows _rows;
    readonly int _linesAbove;

    /// <summary>Reads the header.</summary>
    /// <param name="path">Name of the input in messages.</param>
    /// <param name="linesAbove">Number of lines above the header that the caller has already read.</param>
    public CsvTable(string path, TextReader text, int linesAbove = 0)
    {
        (_path, _rows, _linesAbove) = (path, new CsvRows(text), linesAbove);
        Header = _rows.Next() ? _rows.Fields() : [];
    }

    /// <summary>Names of the columns; empty if the text is empty.</summary>
    public string[] Header { get; }

    /// <summary>File and line of the current row.</summary>
    public string Place => $"{_path}:{_linesAbove + (Header.Length == 0 ? 1 : _rows.Line)}";

    public string this[int column] => _rows[column];

    /// <param name="expected">Names of the columns, separated by commas.</param>
    /// <exception cref="InputException">The table has other columns.</exception>
    public void RequireHeader(string expected)
    {
        var header = string.Join(',', Header);
        if (header != expected) throw Wrong(TableMessages.Header(header.Length <= MaxShown ? header : header[..MaxShown] + "…", expected));
    }

    /// <summary>Moves to the next row.</summary>
    /// <returns>Whether there is a row.</returns>
    /// <exception cref="InputException">The row does not have one field for each column.</exception>
    public bool Next()
    {
        if (!_rows.Next()) return false;
        return _rows.Count == Header.Length ? true : throw Wrong(TableMessages.FieldCount(_rows.Count, Header.Length));
    }

    /// <param name="unit">Unit in the message, for example "nanoseconds".</param>
    /// <exception cref="InputException">The field is not a 64-bit integer.</exception>
    public long Whole(int column, string unit) =>
        long.TryParse(_rows[column], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number)
            ? number : throw Wrong(TableMessages.NotWhole(Header[column], _rows[column], unit));

    /// <inheritdoc cref="Whole"/>
    /// <exception cref="InputException">The field is not a number.</exception>
    public double Number(int column, string unit) =>
        double.TryParse(_rows[column], NumberStyles.Float, CultureInfo.InvariantCulture, out var number)
            ? number : throw Wrong(TableMessages.NotANumber(Header[column], _rows[column], unit));

    /// <summary>Gets a number; null for an empty field.</summary>
    /// <inheritdoc cref="Number"/>
    public double? NumberOrNull(int column, string unit) => _rows[column].Length == 0 ? null : Number(column, unit);

    /// <summary>Creates the exception for an error in the current row.</summary>
    public InputException Wrong(string what) => new($"{Place}: {what}");

    public void Dispose() => _rows.Dispose();
}
