using System.Globalization;
using Spectre.Console;

namespace Nowpose.Cli.Replay;

/// <summary>Prints the result of a replay as a table, with the errors of each axis without and with compensation.</summary>
static class ReplayTable
{
    public static void Write(IAnsiConsole console, ReplayResult result)
    {
        if (result.Axes.Count > 0) WriteAxes(console, result);
        foreach (var body in result.Bodies) Write(console, body);
        if (result.Signals.Count > 0)
            console.WriteLine(OneLine("signals: " + string.Join(", ", result.Signals.Select(signal => $"{signal.Name} ({signal.Changes} changes)"))));
    }

    static void WriteAxes(IAnsiConsole console, ReplayResult result)
    {
        var statesDeviation = result.Axes.Any(axis => axis.Deviation != null);
        var table = Create("axis", result.File, result.Predictor, result.Frames,
            statesDeviation ? ["mean SD", "inside 1 SD", "inside 2 SD", "moving, 2 SD"] : []);
        foreach (var axis in result.Axes)
            table.AddRow([
                Markup.Escape(OneLine(Named(axis.Name, axis.Unit))), .. Cells(axis.Error), .. statesDeviation ? Cells(axis.Deviation) : [],
            ]);
        table.AddEmptyRow();
        void AddTotal(string name, double hold, double rms, double? reduction) =>
            table.AddRow(name, Number(hold), Number(rms), "", "", Percent(reduction));
        foreach (var total in result.Totals) AddTotal(Named(ReplayTexts.All, total.Unit), total.RmsHold, total.Rms, total.Reduction);
        var unit = result.Axes[0].Unit;
        AddTotal(result.Totals.Count > 0 ? ReplayTexts.AllUnits : Named(ReplayTexts.All, unit), result.RmsHold, result.Rms, result.Reduction);
        console.Write(unit == null ? table.Caption(ReplayTexts.Units) : table);
        WritePasses(console, result.Passes);
    }

    static string Named(string name, string unit) => unit == null ? name : $"{name}, {unit}";

    // Nothing for one pass.
    static void WritePasses(IAnsiConsole console, IReadOnlyList<PassRms> passes)
    {
        if (passes.Count > 1)
            console.WriteLine(ReplayTexts.Phases(passes.Count, Number(passes.Min(pass => pass.Rms)), Number(passes.Max(pass => pass.Rms))));
    }

    public static void Write(IAnsiConsole console, BodyReplayResult result)
    {
        var table = Create("rigid body", result.File, result.Predictor, result.Frames);
        void Row(string name, ErrorComparison error) => table.AddRow([name, .. Cells(error)]);
        Row("position, mm", result.Position);
        Row("rotation, °", result.Rotation);
        if (result.Displayed is { } displayed)
        {
            Row(ReplayTexts.DisplayedPosition, displayed.Position);
            Row(ReplayTexts.DisplayedRotation, displayed.Rotation);
        }
        console.Write(table.Caption(ReplayTexts.Body));
        WritePasses(console, result.Passes);
    }

    static Table Create(string subject, string file, string predictor, int frames, params string[] more)
    {
        var table = new Table().Title(Markup.Escape(OneLine($"{Path.GetFileName(file)}: {predictor}, {frames} frames"))).AddColumn(subject);
        foreach (var heading in (string[])["uncompensated RMS", "compensated RMS", "P95", "max", "reduction", .. more])
            table.AddColumn(new TableColumn(heading).RightAligned());
        return table;
    }

    static string[] Cells(ErrorComparison error) =>
        [Number(error.RmsHold), Number(error.Rms), Number(error.P95), Number(error.Max), Percent(error.Reduction)];

    static string[] Cells(ReplayResult.Deviation? deviation) => deviation is ReplayResult.Deviation value
        ? [Number(value.Mean), Percent(value.All.InsideOne), Percent(value.All.InsideTwo), Percent(value.Moving.InsideTwo)]
        : ["–", "–", "–", "–"];

    // Names in a file may contain characters that control a terminal. The limit is that of 256 names.
    static string OneLine(string text) => InputException.OneLine(text, 1 << 16);

    static string Number(double value) => value.ToString("G4", CultureInfo.InvariantCulture);

    static string Percent(double? share) =>
        share is double value ? (100 * value).ToString("F1", CultureInfo.InvariantCulture) + " %" : "–";
}
