using System.Globalization;
using System.Text.Json;
using Nowpose.Cli.Figures;

namespace Nowpose.Cli.Calibrate;

/// <summary>Creates the JSON that calibration.html reads. <c>Web/src/calibration/data.ts</c> declares its fields.</summary>
static class CalibrationJson
{
    static readonly JsonSerializerOptions Options = new() { PropertyNamingPolicy = JsonNamingPolicy.SnakeCaseLower };

    public static string Of(CalibrationPageData page) => JsonSerializer.Serialize(new
    {
        page.Title,
        page.Result,
        page.Warnings,
        Facts = page.Facts.Append(["Evaluated", DateTime.UtcNow.ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture) + " UTC"]),
        Sections = page.Sections.Select(Of),
    }, Options);

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
