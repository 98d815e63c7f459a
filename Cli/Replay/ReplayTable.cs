using System.Globalization;
using Nowpose.Cli.Messages;
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
        var title = $"{Path.GetFileName(result.File)}: {result.Predictor}, {result.Frames} frames";
        var table = new Table().Title(Markup.Escape(OneLine(title)));
        string[] headings = ["uncompensated RMS", "compensated RMS", "P95", "max", "reduction"];
        var statesDeviation = result.Axes.Any(axis => axis.Deviation != null);
        if (statesDeviation) headings = [.. headings, "mean SD", "inside 1 SD", "inside 2 SD"];
        table.AddColumn("axis");
        foreach (var heading in headings) table.AddColumn(new TableColumn(heading).RightAligned());
        foreach (var axis in result.Axes)
            table.AddRow([Markup.Escape(OneLine(axis.Name)), Number(axis.RmsHold), Number(axis.Rms), Number(axis.P95), Number(axis.Max),
                Percent(axis.RmsHold == 0 ? null : 1 - axis.Rms / axis.RmsHold), .. statesDeviation ? Of(axis.Deviation) : []]);
        table.AddEmptyRow();
        table.AddRow("all", Number(result.RmsHold), Number(result.Rms), "", "", Percent(result.Reduction));
        table.Caption(ReplayTexts.Units);
        console.Write(table);
    }

    public static void Write(IAnsiConsole console, BodyReplayResult result)
    {
        var title = $"{Path.GetFileName(result.File)}: {result.Predictor}, {result.Frames} frames";
        var table = new Table().Title(Markup.Escape(OneLine(title)));
        table.AddColumn("rigid body");
        foreach (var heading in new[] { "uncompensated RMS", "compensated RMS", "P95", "max", "reduction" })
            table.AddColumn(new TableColumn(heading).RightAligned());
        List<(string Name, BodyReplayResult.ErrorSize Error)> rows = [("position, mm", result.Position), ("rotation, °", result.Rotation)];
        if (result.Displayed is { } displayed)
            rows.AddRange([(ReplayTexts.DisplayedPosition, displayed.Position), (ReplayTexts.DisplayedRotation, displayed.Rotation)]);
        foreach (var (name, error) in rows)
            table.AddRow(name, Number(error.RmsHold), Number(error.Rms), Number(error.P95), Number(error.Max), Percent(error.Reduction));
        table.Caption(ReplayTexts.Body);
        console.Write(table);
    }

    static string[] Of(ReplayResult.Deviation? deviation) => deviation is ReplayResult.Deviation value
        ? [Number(value.Mean), Percent(value.InsideOne), Percent(value.InsideTwo)] : ["–", "–", "–"];

    // Names in a file may contain characters that control a terminal. The limit is that of 256 names.
    static string OneLine(string text) => InputException.OneLine(text, 1 << 16);

    static string Number(double value) => value.ToString("G4", CultureInfo.InvariantCulture);

    static string Percent(double? share) =>
        share is double value ? (100 * value).ToString("F1", CultureInfo.InvariantCulture) + " %" : "–";
}
