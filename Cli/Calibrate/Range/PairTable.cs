using System.Globalization;
using Nowpose.Cli.Messages;
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
        using var csv = new CsvRows(text);
        var header = csv.Next() ? csv.Fields() : [];
        int render = Column(header, Render, path), visu = Column(header, Visu, path);
        int vertices = Array.IndexOf(header, Vertices), file = Array.IndexOf(header, File);
        var pairs = new List<MeasuredPicture>();
        var origin = new Dictionary<string, string>();
        var origins = PairOrigin.Columns.Select(name => (name, Index: Array.IndexOf(header, name))).Where(column => column.Index >= 0).ToArray();
        while (csv.Next())
        {
            if (csv.Count != header.Length) throw new InputException(PairFileMessages.FieldCount(path, csv.Line, csv.Count, header.Length));
            if (pairs.Count == MaxRows) throw new InputException(PairFileMessages.TooManyRows(path, csv.Line, MaxRows));
            pairs.Add(Picture(csv, path, render, visu, vertices, file));
            // A value may be missing in some rows: a sweep's log lacks those that the headset does not know yet.
            foreach (var (name, index) in origins.Where(column => csv[column.Index].Length > 0))
                if (origin.TryAdd(name, csv[index])) InputPlace.In($"{path}:{csv.Line}", () => PairOrigin.Parse(each => each == name ? csv[index] : null));
                else if (origin[name] != csv[index])
                    throw new InputException(PairFileMessages.TwoOrigins(path, csv.Line, name, origin[name], csv[index]));
        }
        if (pairs.Count == 0) throw new InputException(PairFileMessages.NoRows(path, RangeFit.MinPairs));
        return (pairs, PairOrigin.Parse(origin.GetValueOrDefault));
    }

    static int Column(string[] header, string name, string path)
    {
        var index = Array.IndexOf(header, name);
        if (index < 0) throw new InputException(PairFileMessages.NoColumn(path, name, Render, Visu));
        return Array.LastIndexOf(header, name) == index ? index : throw new InputException(PairFileMessages.ColumnTwice(path, name));
    }

    static MeasuredPicture Picture(CsvRows csv, string path, int render, int visu, int vertices, int file)
    {
        double renderMs = Number(csv, path, render, Render), visuMs = Number(csv, path, visu, Visu);
        int? load = vertices < 0 || csv[vertices].Length == 0 ? null : Count(csv, path, vertices);
        return InputPlace.In($"{path}:{csv.Line}", () => new MeasuredPicture(
            file < 0 ? null : csv[file], load, MeasuredRenderTime.RequireMs(renderMs), SettingRange.Require(visuMs, -MaxVisuMs, MaxVisuMs, Visu, "ms")));
    }

    static double Number(CsvRows csv, string path, int column, string name) =>
        double.TryParse(csv[column], NumberStyles.Float, CultureInfo.InvariantCulture, out var value)
            ? value
            : throw new InputException(PairFileMessages.NotMilliseconds(path, csv.Line, name, csv[column]));

    static int Count(CsvRows csv, string path, int column) =>
        int.TryParse(csv[column], NumberStyles.None, CultureInfo.InvariantCulture, out var value) && value <= MaxVertices
            ? value
            : throw new InputException(PairFileMessages.NotVertices(path, csv.Line, Vertices, csv[column], MaxVertices));
}
