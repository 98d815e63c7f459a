using System.Globalization;
using CsvHelper;
using CsvHelper.Configuration;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Sync;

/// <summary>Reads CSV files of integers with a fixed header. Error messages name file, line and field.</summary>
static class IntegerTable
{
    /// <summary>Maximum number of characters of a wrong header that a message shows.</summary>
    const int MaxShown = 120;

    /// <exception cref="InputException">The file cannot be read or has another format.</exception>
    public static List<long[]> Read(string path, params string[] header)
    {
        using var text = RecordingText.Open(path);
        using var csv = new CsvParser(
            text, new CsvConfiguration(CultureInfo.InvariantCulture) { TrimOptions = TrimOptions.Trim, BadDataFound = null });
        try
        {
            return Rows(csv, path, header);
        }
        catch (Exception e) when (e is IOException or InvalidDataException)
        {
            throw RecordingText.Unreadable(path, e);
        }
    }

    static List<long[]> Rows(CsvParser csv, string path, string[] header)
    {
        if (!csv.Read() || !csv.Record.SequenceEqual(header))
            throw new InputException(
                ExchangeFileMessages.Header(path, Beginning(csv.Record == null ? "" : string.Join(',', csv.Record)), string.Join(',', header)));
        var rows = new List<long[]>();
        while (csv.Read())
            rows.Add(Row(csv, path, header));
        if (rows.Count == 0) throw new InputException(ExchangeFileMessages.NoRows(path));
        return rows;
    }

    // Limits the length, because a file of another format can have a very long first line.
    static string Beginning(string header) => header.Length <= MaxShown ? header : header[..MaxShown] + "…";

    static long[] Row(CsvParser csv, string path, string[] header)
    {
        if (csv.Count != header.Length)
            throw new InputException(ExchangeFileMessages.FieldCount(path, csv.RawRow, csv.Count, header.Length));
        var row = new long[header.Length];
        for (var i = 0; i < row.Length; i++)
            if (!long.TryParse(csv[i], NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out row[i]))
                throw new InputException(ExchangeFileMessages.NotNanoseconds(path, csv.RawRow, header[i], csv[i]));
        return row;
    }
}
