using System.Globalization;
using Nowpose.Cli.Figures;

namespace Nowpose.Cli.Calibrate;

/// <summary>Creates the JSON that calibration.html reads. <c>Web/src/calibration/data.ts</c> declares its fields.</summary>
static class CalibrationJson
{
    public static string Of(CalibrationPageData page) => JsonText.Of(new
    {
        page.Title,
        page.Result,
        page.Warnings,
        Facts = page.Facts.Append(["Evaluated", DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture) + " UTC"]),
        Sections = page.Sections.Select(Of),
    }, isIndented: false);

    static object Of(CalibrationSection section) => new
    {
        section.Heading,
        section.Source,
        section.Words,
        Plots = section.Plots.Select(PlotJson.Of),
        Table = section.Table == null
            ? null
            : new { Columns = section.Table.Columns.Select(column => column.Label), Rows = PlotJson.Rows(section.Table) },
    };
}
