using Nowpose.Cli.Messages;
using Nowpose.Cli.SessionFiles;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <summary>Reads logs of sync exchanges, and the instants for which estimates are requested.</summary>
static class SyncLog
{
    /// <summary>Reads the exchanges of a log without checking them. Also returns their t4 in ns, because the time types round to 100 ns.</summary>
    public static IReadOnlyList<(long T4Nanoseconds, SyncExchange Exchange)> Read(string path) =>
        RecordingText.IsSession(path) ? OfSession(path) : OfTable(path);

    static List<(long, SyncExchange)> OfTable(string path)
    {
        var rows = IntegerTable.Read(path, "t1_ns", "t2_ns", "t3_ns", "t4_ns");
        var resolution = LoggedResolution.Of(rows);
        return rows.ConvertAll(row => (row[3], new SyncExchange(
            HeadsetTime.FromNanoseconds(row[0]), ControlTime.FromNanoseconds(row[1]),
            ControlTime.FromNanoseconds(row[2]), HeadsetTime.FromNanoseconds(row[3]), resolution)));
    }

    static List<(long, SyncExchange)> OfSession(string path)
    {
        using var file = new SessionFileReader(path);
        var exchanges = file.Lines().OfType<SyncLine>().Select(line => (line.T4Nanoseconds, line.Exchange)).ToList();
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
