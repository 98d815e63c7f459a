using System.Globalization;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.MotionRecordings;
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

    const string Nanoseconds = "control_ns", Vertices = "vertices", RenderMs = "render_ms", DisplayHz = "display_hz";

    static readonly int Columns = SweepLog.Header.Split(',').Length;

    /// <param name="name">Name of the input in messages.</param>
    /// <param name="conditions">Conditions from the lines above the header. Device and display rate are in the rows instead.</param>
    /// <exception cref="InputException">The text is not in the expected format, contains no rows, or contains several headsets.</exception>
    public static IReadOnlyList<SweepRow> Read(TextReader text, string name, out DisplayConditions conditions)
    {
        var above = 1;
        var header = text.ReadLine();
        var values = new string[DisplayConditionNames.Count];
        for (; IsComment(header); header = text.ReadLine(), above++) TakeCondition(header, values, $"{name}:{above}");
        conditions = DisplayConditions.Parse(condition => values[(int)condition]);
        if (header == null || header.Trim() != SweepLog.Header)
            throw new InputException(SweepFileMessages.Header(name, above, header, SweepLog.Header));
        using var csv = new CsvRows(text);
        var rows = new List<SweepRow>();
        var (device, headset, rate) = ("", "", double.NaN);
        while (csv.Next())
        {
            var place = $"{name}:{above + csv.Line}";
            rows.Add(RowOf(csv, place, ref device));
            RequireOneHeadset(rows[^1], place, ref headset, ref rate);
        }
        if (rows.Count == 0) throw new InputException(SweepFileMessages.NoRows(name));
        return rows;
    }

    /// <param name="device">Device of the earlier rows; empty if unknown.</param>
    /// <param name="rate">Display rate of the earlier rows; NaN if unknown.</param>
    static void RequireOneHeadset(in SweepRow row, string place, ref string device, ref double rate)
    {
        if (device.Length == 0) device = row.Device;
        else if (row.Device.Length > 0 && row.Device != device)
            throw new InputException(SweepFileMessages.TwoHeadsets(place, device, row.Device));
        if (double.IsNaN(rate)) rate = row.DisplayHz;
        else if (!double.IsNaN(row.DisplayHz) && row.DisplayHz != rate)
            throw new InputException(SweepFileMessages.TwoRates(place, rate, row.DisplayHz));
    }

    static bool IsComment(string line) => line != null && line.StartsWith(SweepLog.ConditionPrefix, StringComparison.Ordinal);

    // Reads one condition. Ignores unknown fields, which a newer version may have added.
    static void TakeCondition(string line, string[] values, string place)
    {
        var end = line.IndexOf(SweepLog.ConditionSeparator, StringComparison.Ordinal);
        if (end < 0) return;
        if (!DisplayConditionNames.TryParse(line[SweepLog.ConditionPrefix.Length..end], out var condition)) return;
        var value = line[(end + SweepLog.ConditionSeparator.Length)..].Trim();
        InputPlace.In(place, () => DisplayConditions.Parse(each => each == condition ? value : null));
        values[(int)condition] = value;
    }

    /// <param name="device">Device of the previous row. An equal device reuses this string to save memory.</param>
    static SweepRow RowOf(CsvRows fields, string place, ref string device)
    {
        if (fields.Count != Columns) throw new InputException(SweepFileMessages.FieldCount(place, fields.Count, Columns));
        if (fields[4] != device) device = fields[4];
        var model = device;
        return InputPlace.In(place, () => new SweepRow(
            ControlTime.FromNanoseconds(Whole(fields[0], Nanoseconds, "nanoseconds")),
            (int)Math.Min(Whole(fields[1], Vertices, "vertices"), int.MaxValue),
            fields[2].Length == 0 ? null : Number(fields[2], RenderMs, "milliseconds"),
            SourceOf(fields[3]),
            model,
            fields[5].Length == 0 ? double.NaN : Number(fields[5], DisplayHz, "hertz")));
    }

    /// <summary>Parses a field of the column <see cref="Source"/>; an empty one is <see cref="RenderTimeSourceKind.None"/>.</summary>
    /// <exception cref="InputException">The field is not the name of a source.</exception>
    public static RenderTimeSourceKind SourceOf(string text)
    {
        if (LatencyNames.RenderTimeSource.TryParse(text, out var source)) return source;
        throw new InputException(SweepFileMessages.UnknownSource(Source, text, LatencyNames.RenderTimeSource.All));
    }

    static long Whole(string text, string field, string unit)
    {
        if (long.TryParse(text, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number)) return number;
        throw new InputException(SweepFileMessages.NotWhole(field, text, unit));
    }

    static double Number(string text, string field, string unit)
    {
        if (double.TryParse(text, NumberStyles.Float, CultureInfo.InvariantCulture, out var number)) return number;
        throw new InputException(SweepFileMessages.NotANumber(field, text, unit));
    }
}
