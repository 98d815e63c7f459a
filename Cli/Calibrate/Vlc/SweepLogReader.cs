using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Sweep;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>
/// Reads the text that <see cref="SweepLog"/> writes. All rows must come from one headset with one display rate. An error message is one line
/// with file, line and field.
/// </summary>
static class SweepLogReader
{
    /// <summary>Name of the column with the source of the render time.</summary>
    public const string Source = "source";

    /// <param name="name">Name of the input in messages.</param>
    /// <param name="conditions">Conditions from the lines above the header. Device and display rate are in the rows instead.</param>
    /// <exception cref="InputException">The text is not in the expected format, contains no rows, or contains several headsets.</exception>
    public static IReadOnlyList<SweepRow> Read(TextReader text, string name, out DisplayConditions conditions)
    {
        var above = 0;
        var values = new string[DisplayConditionNames.Count];
        while (text.Peek() == SweepLog.ConditionPrefix[0]) TakeCondition(text.ReadLine(), values, $"{name}:{++above}");
        conditions = DisplayConditions.Parse(condition => values[(int)condition]);
        using var table = new CsvTable(name, text, above);
        table.RequireHeader(SweepLog.Header);
        var rows = new List<SweepRow>();
        var (device, headset, rate) = ("", "", double.NaN);
        while (table.Next())
        {
            rows.Add(RowOf(table, ref device));
            RequireOneHeadset(rows[^1], table, ref headset, ref rate);
        }
        if (rows.Count == 0) throw new InputException(TableMessages.NoRows(name, 1));
        return rows;
    }

    /// <param name="device">Device of the earlier rows; empty if unknown.</param>
    /// <param name="rate">Display rate of the earlier rows; NaN if unknown.</param>
    static void RequireOneHeadset(in SweepRow row, CsvTable table, ref string device, ref double rate)
    {
        if (device.Length == 0) device = row.Device;
        else if (row.Device.Length > 0 && row.Device != device)
            throw table.Wrong(SweepFileMessages.TwoHeadsets(device, row.Device));
        if (double.IsNaN(rate)) rate = row.DisplayHz;
        else if (!double.IsNaN(row.DisplayHz) && row.DisplayHz != rate)
            throw table.Wrong(SweepFileMessages.TwoRates(rate, row.DisplayHz));
    }

    // Reads one condition. Ignores unknown fields, which a newer version may have added.
    static void TakeCondition(string line, string[] values, string place)
    {
        var end = line.IndexOf(SweepLog.ConditionSeparator, StringComparison.Ordinal);
        if (end < 0 || !line.StartsWith(SweepLog.ConditionPrefix, StringComparison.Ordinal)) return;
        if (!DisplayConditionNames.TryParse(line[SweepLog.ConditionPrefix.Length..end], out var condition)) return;
        var value = line[(end + SweepLog.ConditionSeparator.Length)..].Trim();
        InputPlace.In(place, () => DisplayConditions.Parse(each => each == condition ? value : null));
        values[(int)condition] = value;
    }

    /// <param name="device">Device of the previous row. An equal device reuses this string to save memory.</param>
    static SweepRow RowOf(CsvTable table, ref string device)
    {
        if (table[4] != device) device = table[4];
        var model = device;
        var (time, vertices) = (ControlTime.FromNanoseconds(table.Whole(0, "nanoseconds")), table.Whole(1, "vertices"));
        var (renderMs, displayHz) = (table.NumberOrNull(2, "milliseconds"), table.NumberOrNull(5, "hertz") ?? double.NaN);
        return InputPlace.In(table.Place, () => new SweepRow(time, vertices, renderMs, SourceOf(table[3]), model, displayHz));
    }

    /// <summary>Parses a field of the column <see cref="Source"/>; an empty one is <see cref="RenderTimeSourceKind.None"/>.</summary>
    /// <exception cref="InputException">The field is not the name of a source.</exception>
    public static RenderTimeSourceKind SourceOf(string text)
    {
        if (LatencyNames.RenderTimeSource.TryParse(text, out var source)) return source;
        throw new InputException(SweepFileMessages.UnknownSource(Source, text, LatencyNames.RenderTimeSource.All));
    }
}
