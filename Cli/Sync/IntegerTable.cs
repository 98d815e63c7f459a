using System.Globalization;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Sync;

/// <summary>Reads CSV files of integers with a fixed header. Error messages name file, line and field.</summary>
static class IntegerTable
{
    /// <summary>Maximum number of characters of a wrong header that a message shows.</summary>
    const int MaxShown = 120;

    /// <exception cref="InputException">The file cannot be read or has another format.</exception>
    public static List<long[]> Read(string path, params string[] header) => [.. ReadWithLines(path, header).Select(row => row.Values)];

    /// <summary>Reads the rows and the line of each row.</summary>
    /// <exception cref="InputException">The file cannot be read or has another format.</exception>
    public static List<(int Line, long[] Values)> ReadWithLines(string path, params string[] header) =>
        RecordingText.Read(path, text => Rows(text, path, header));

    static List<(int, long[])> Rows(TextReader text, string path, string[] header)
    {
        using var csv = new CsvRows(text);
        var first = csv.Next() ? csv.Fields() : [];
        if (!first.SequenceEqual(header))
            throw new InputException(ExchangeFileMessages.Header(path, csv.Line, Beginning(string.Join(',', first)), string.Join(',', header)));
        var rows = new List<(int, long[])>();
        while (csv.Next()) rows.Add((csv.Line, Row(csv, path, header)));
        if (rows.Count == 0) throw new InputException(ExchangeFileMessages.NoRows(path));
        return rows;
    }

    // Limits the length, because a file of another format can have a very long first line.
    static string Beginning(string header) => header.Length <= MaxShown ? header : header[..MaxShown] + "…";

    static long[] Row(CsvRows csv, string path, string[] header)
    {
        if (csv.Count != header.Length)
            throw new InputException(ExchangeFileMessages.FieldCount(path, csv.Line, csv.Count, header.Length));
        var row = new long[header.Length];
        for (var i = 0; i < row.Length; i++)
            if (!long.TryParse(csv[i], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out row[i]))
                throw new InputException(ExchangeFileMessages.NotNanoseconds(path, csv.Line, header[i], csv[i]));
        return row;
    }
}
