using Nowpose.Cli.Messages;
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

    static List<LoggedExchange> OfTable(string path) => IntegerTable.Read(path, "t1_ns", "t2_ns", "t3_ns", "t4_ns")
        .ConvertAll(row => LoggedExchange.Of(new LoggedStamps(row[0], row[1], row[2], row[3])));

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
        var instants = new List<long>();
        foreach (var (line, values) in IntegerTable.ReadWithLines(path, "t_ns"))
        {
            if (instants.Count > 0 && values[0] <= instants[^1])
                throw new InputException(ExchangeFileMessages.TimeOrder(path, line, values[0], instants[^1]));
            instants.Add(values[0]);
        }
        return instants;
    }
}
