using System.Globalization;
using CsvHelper;
using CsvHelper.Configuration;

namespace Nowpose.Gateway.MotionRecordings;

/// <summary>Reads CSV text row by row, without blank rows and without white space around the fields.</summary>
public sealed class CsvRows : IDisposable
{
    readonly CsvParser _csv;

    /// <param name="onBadQuote">
    /// Called with the line and the field in which a quotation mark is misplaced or not closed; null to read the rest of such a row as text.
    /// </param>
    public CsvRows(TextReader text, Action<int, string> onBadQuote = null) =>
        _csv = new CsvParser(text, new CsvConfiguration(CultureInfo.InvariantCulture)
        {
            TrimOptions = TrimOptions.Trim,
            // The parser would count the blank lines before a row as a part of it.
            IgnoreBlankLines = false,
            // A quoted field may extend over many lines.
            MaxFieldSize = RecordingText.MaxLineMebibytes << 20,
            BadDataFound = onBadQuote == null ? null : bad => onBadQuote(Line, bad.Field),
        });

    /// <summary>Line in which the current row starts. With a quotation mark that is not closed, the row extends to the end of the text.</summary>
    public int Line { get; private set; }

    public int Count => _csv.Count;

    public string this[int column] => _csv[column];

    /// <summary>Gets the fields of the current row, as a new array.</summary>
    public string[] Fields() => [.. Enumerable.Range(0, _csv.Count).Select(column => _csv[column])];

    /// <summary>Moves to the next row.</summary>
    /// <returns>Whether there is a row.</returns>
    public bool Next()
    {
        do
        {
            Line = _csv.RawRow + 1;
            if (!_csv.Read()) return false;
        }
        while (_csv.Count == 1 && string.IsNullOrWhiteSpace(_csv[0]));
        return true;
    }

    public void Dispose() => _csv.Dispose();
}
