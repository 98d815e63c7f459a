using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway.MotionRecordings;

namespace Nowpose.Cli.Sync;

/// <summary>Reads logs of sync exchanges, and the instants for which estimates are requested.</summary>
static class SyncLog
{
    /// <summary>Reads the exchanges of a log without checking them.</summary>
    /// <param name="lost">Number of lines that the recording of a session lost.</param>
    public static IReadOnlyList<LoggedExchange> Read(string path, out long lost)
    {
        lost = 0;
        return RecordingText.IsSession(path) ? OfSession(path, ref lost) : OfTable(path);
    }

    static List<LoggedExchange> OfTable(string path) => Rows(path, "t1_ns,t2_ns,t3_ns,t4_ns", table =>
        LoggedExchange.Of(new LoggedStamps(Nanoseconds(table, 0), Nanoseconds(table, 1), Nanoseconds(table, 2), Nanoseconds(table, 3))));

    static List<LoggedExchange> OfSession(string path, ref long lost)
    {
        using var file = new SessionFileReader(path);
        var exchanges = new List<LoggedExchange>();
        foreach (var line in file.Lines())
        {
            if (line is SyncLine sync) exchanges.Add(new LoggedExchange(sync.T4Nanoseconds, sync.Exchange, Stamps: null));
            if (line is LostLine missing) lost += missing.Count;
        }
        return exchanges.Count > 0 ? exchanges : throw new InputException(ExchangeFileMessages.NoExchange(path));
    }

    public static IReadOnlyList<long> ReadInstants(string path)
    {
        long? previous = null;
        return Rows(path, "t_ns", table =>
        {
            var instant = Nanoseconds(table, 0);
            if (instant <= previous) throw table.Wrong(ExchangeFileMessages.TimeOrder(instant, previous.Value));
            previous = instant;
            return instant;
        });
    }

    static List<T> Rows<T>(string path, string header, Func<CsvTable, T> read) => RecordingText.Read(path, text =>
    {
        using var table = new CsvTable(path, text);
        table.RequireHeader(header);
        var rows = new List<T>();
        while (table.Next()) rows.Add(read(table));
        return rows.Count > 0 ? rows : throw new InputException(TableMessages.NoRows(path, 1));
    });

    static long Nanoseconds(CsvTable table, int column) => table.Whole(column, "nanoseconds");
}
