using System.Globalization;
using Nowpose.Gateway.MotionRecordings;
using Nowpose.Latency;

namespace Nowpose.Cli.Calibrate.Range;

/// <summary>
/// Reads pairs of render time and L_visu from the columns render_ms and visu_ms, and optionally vertices, file and those of
/// <see cref="PairOrigin"/>. Other columns are ignored.
/// </summary>
static class PairTable
{
    const string Render = "render_ms", Visu = "visu_ms", Vertices = "vertices", File = "file";
    const int MaxVertices = 1_000_000_000;

    /// <summary>Maximum absolute L_visu, ms. Codes repeat after this time, so a misread picture can be wrong by the same amount.</summary>
    const double MaxVisuMs = TimestampCode.PeriodMs;

    /// <summary>Maximum number of rows. A one-day recording at 60 Hz has five million.</summary>
    const int MaxRows = 10_000_000;

    /// <exception cref="InputException">The file cannot be read or has another format. The message names file, line and field.</exception>
    public static (IReadOnlyList<MeasuredPicture> Pairs, PairOrigin Origin) Read(string path) => RecordingText.Read(path, text => Rows(text, path));

    static (IReadOnlyList<MeasuredPicture> Pairs, PairOrigin Origin) Rows(TextReader text, string path)
    {
        using var table = new CsvTable(path, text);
        int render = Column(table, Render), visu = Column(table, Visu);
        int vertices = Array.IndexOf(table.Header, Vertices), file = Array.IndexOf(table.Header, File);
        var pairs = new List<MeasuredPicture>();
        var origin = new Dictionary<string, string>();
        var origins = PairOrigin.Columns.Select(name => (name, Index: Array.IndexOf(table.Header, name))).Where(column => column.Index >= 0).ToArray();
        while (table.Next())
        {
            if (pairs.Count == MaxRows) throw table.Wrong(PairFileMessages.TooManyRows(MaxRows));
            pairs.Add(Picture(table, render, visu, vertices, file));
            // A value may be missing in some rows: a sweep's log lacks those that the headset does not know yet.
            foreach (var (name, index) in origins.Where(column => table[column.Index].Length > 0))
                if (origin.TryAdd(name, table[index])) InputPlace.In(table.Place, () => PairOrigin.Parse(each => each == name ? table[index] : null));
                else if (origin[name] != table[index])
                    throw table.Wrong(PairFileMessages.TwoOrigins(name, origin[name], table[index]));
        }
        if (pairs.Count == 0) throw new InputException(TableMessages.NoRows(path, RangeFit.MinPairs));
        return (pairs, PairOrigin.Parse(origin.GetValueOrDefault));
    }

    static int Column(CsvTable table, string name)
    {
        var index = Array.IndexOf(table.Header, name);
        if (index < 0) throw table.Wrong(PairFileMessages.NoColumn(name, Render, Visu));
        return Array.LastIndexOf(table.Header, name) == index ? index : throw table.Wrong(PairFileMessages.ColumnTwice(name));
    }

    static MeasuredPicture Picture(CsvTable table, int render, int visu, int vertices, int file)
    {
        double renderMs = table.Number(render, "milliseconds"), visuMs = table.Number(visu, "milliseconds");
        int? load = vertices < 0 || table[vertices].Length == 0 ? null : Count(table, vertices);
        return InputPlace.In(table.Place, () => new MeasuredPicture(
            file < 0 ? null : table[file], load, MeasuredRenderTime.RequireMs(renderMs), SettingRange.Require(visuMs, -MaxVisuMs, MaxVisuMs, Visu, "ms")));
    }

    static int Count(CsvTable table, int column) =>
        int.TryParse(table[column], NumberStyles.None, CultureInfo.InvariantCulture, out var value) && value <= MaxVertices
            ? value
            : throw table.Wrong(PairFileMessages.NotVertices(Vertices, table[column], MaxVertices));
}
