using System.Globalization;
using System.Text;
using System.Text.Json;
using Nowpose.Web.Messages;
using static Nowpose.Web.PlainPage;

namespace Nowpose.Web;

/// <summary>Creates the report without plots and JavaScript, for builds without Node.js.</summary>
public static class PlainReport
{
    /// <param name="report">Data as for <see cref="Pages.Report"/>.</param>
    public static string Render(JsonElement report)
    {
        var title = Text(report, "title");
        var html = Begin(title.Length == 0 ? "Nowpose report" : title, "body{color-scheme:light dark}");
        Append(html, $"<p>{Text(report, "subtitle")}</p>\n");
        Section(html, report, "summary", "Uncompensated against compensated", ["Quantity", "Uncompensated", "Compensated"],
            row => [Label(row), Number(row, "uncompensated"), Number(row, "compensated")]);
        // The claims of the paper are in the data only after a run of the paper's scenario.
        if (report.TryGetProperty("claims", out var claims) && claims.ValueKind == JsonValueKind.Array)
            Section(html, report, "claims", PlainTexts.Claims, ["Figure", "Claim", "Paper", "Measured", "Verdict"],
                claim => ["Fig. " + Text(claim, "figure"), Text(claim, "claim"), Text(claim, "paper"), Text(claim, "measured"), Text(claim, "verdict")]);
        Section(html, report, "facts", "Measured", ["Name", "Value"], Cells);
        Section(html, report, "settings", "Settings", ["Name", "Value"], Cells);
        return End(html);
    }

    static void Section(
        StringBuilder html, JsonElement report, string name, string caption, IEnumerable<string> header, Func<JsonElement, IEnumerable<string>> row)
    {
        var rows = Items(report, name).Select(row).ToList();
        if (rows.Count > 0) Table(html, caption, header, rows);
        else Append(html, $"<p>{PlainTexts.NotMeasured(caption)}</p>\n");
    }

    static string Label(JsonElement row) => Text(row, "unit") is { Length: > 0 } unit ? $"{Text(row, "label")} ({unit})" : Text(row, "label");

    static string Number(JsonElement row, string name) =>
        row.TryGetProperty(name, out var number) && number.ValueKind == JsonValueKind.Number ? number.GetDouble().ToString("G4", CultureInfo.InvariantCulture) : "–";
}
