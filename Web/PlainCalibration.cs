using System.Text.Json;
using static Nowpose.Web.PlainPage;

namespace Nowpose.Web;

/// <summary>Creates the page of a calibration without plots and JavaScript, for builds without Node.js.</summary>
public static class PlainCalibration
{
    /// <param name="page">Data as for <see cref="Pages.Calibration"/>.</param>
    public static string Render(JsonElement page)
    {
        var html = Begin(Text(page, "title"), "body{color-scheme:light dark}");
        Append(html, $"<p><strong>{Text(page, "result")}</strong></p>\n");
        foreach (var warning in Items(page, "warnings")) Append(html, $"<p role=\"alert\">{Encoded(warning)}</p>\n");
        Table(html, "Result", ["Name", "Value"], Items(page, "facts").Select(Cells));
        foreach (var section in Items(page, "sections"))
        {
            Append(html, $"<h2>{Text(section, "heading")}</h2>\n<p>{Text(section, "words")}</p>\n");
            if (section.TryGetProperty("table", out var table) && table.ValueKind == JsonValueKind.Object)
                Table(html, Text(section, "heading"), Cells(table.GetProperty("columns")), Items(table, "rows").Select(Cells));
        }
        return End(html);
    }
}
