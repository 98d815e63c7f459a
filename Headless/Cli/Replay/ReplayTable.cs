using System.Globalization;
using Spectre.Console;

namespace Nowpose.Cli.Replay;

/// <summary>A replay's result for reading: uncompensated against compensated, axis by axis.</summary>
static class ReplayTable
{
    public static void Write(IAnsiConsole console, ReplayResult result)
    {
        var title = $"{Path.GetFileName(result.File)}: {result.Predictor}, {result.Frames} frames";
        var table = new Table().Title(Markup.Escape(title));
        table.AddColumn("axis");
        foreach (var heading in new[] { "uncompensated RMS", "compensated RMS", "P95", "max", "reduction" })
            table.AddColumn(new TableColumn(heading).RightAligned());
        foreach (var axis in result.Axes)
            table.AddRow(Markup.Escape(axis.Name), Number(axis.RmsHold), Number(axis.Rms), Number(axis.P95), Number(axis.Max),
                Percent(axis.RmsHold == 0 ? null : 1 - axis.Rms / axis.RmsHold));
        table.AddEmptyRow();
        table.AddRow("all", Number(result.RmsHold), Number(result.Rms), "", "", Percent(result.Reduction));
        table.Caption("errors in the unit of the file's columns");
        console.Write(table);
    }

    static string Number(double value) => value.ToString("G4", CultureInfo.InvariantCulture);

    static string Percent(double? share) =>
        share is double value ? (100 * value).ToString("F1", CultureInfo.InvariantCulture) + " %" : "–";
}
