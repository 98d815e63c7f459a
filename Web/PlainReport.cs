using System.Globalization;
using System.Net;
using System.Text;
using System.Text.Json;
using Nowpose.Web.Messages;

namespace Nowpose.Web;

/// <summary>Creates the report without plots and JavaScript, for builds without Node.js.</summary>
public static class PlainReport
{
    const string Style = "body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color-scheme:light dark}"
        + "table{border-collapse:collapse;margin:1rem 0}caption{font-weight:600;text-align:left}"
        + "th,td{padding:.25rem 1rem .25rem 0;border-bottom:1px solid #8886;text-align:left}.n{text-align:right}";

    /// <param name="report">Data as for <see cref="ReportPage.Render"/>.</param>
    public static string Render(JsonElement report)
    {
        var title = Text(report, "title") ?? "Nowpose report";
        var page = new StringBuilder();
        page.Append("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
            .Append("<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n")
            .Append(CultureInfo.InvariantCulture, $"<title>{Encode(title)}</title>\n<style>{Style}</style>\n</head>\n<body>\n")
            .Append(CultureInfo.InvariantCulture, $"<h1>{Encode(title)}</h1>\n<p>{Encode(Text(report, "subtitle"))}</p>\n");
        AppendSummary(page, report);
        AppendClaims(page, report);
        AppendFacts(page, report, "facts", "Measured");
        AppendFacts(page, report, "settings", "Settings");
        return page.Append("<p>").Append(PlainTexts.NoPlotsInReport).Append("</p>\n</body>\n</html>\n").ToString();
    }

    static void AppendSummary(StringBuilder page, JsonElement report)
    {
        const string Caption = "Uncompensated against compensated";
        AppendTable(page, report, "summary", Caption, "<th>Quantity</th><th>Uncompensated</th><th>Compensated</th>", row =>
        {
            var unit = Text(row, "unit");
            var label = string.IsNullOrEmpty(unit) ? Text(row, "label") : $"{Text(row, "label")} ({unit})";
            return $"<th>{Encode(label)}</th>{NumberCell(row, "uncompensated")}{NumberCell(row, "compensated")}";
        });
    }

    // Adds the claims of the paper, which are in the data only after a run of the paper's scenario.
    static void AppendClaims(StringBuilder page, JsonElement report)
    {
        if (!report.TryGetProperty("claims", out var claims) || claims.ValueKind != JsonValueKind.Array) return;
        const string Header = "<th>Figure</th><th>Claim</th><th>Paper</th><th>Measured</th><th>Verdict</th>";
        AppendTable(page, report, "claims", PlainTexts.Claims, Header, claim =>
            $"<th>Fig. {Encode(Text(claim, "figure"))}</th><td>{Encode(Text(claim, "claim"))}</td><td>{Encode(Text(claim, "paper"))}</td>"
            + $"<td>{Encode(Text(claim, "measured"))}</td><td>{Encode(Text(claim, "verdict"))}</td>");
    }

    static void AppendFacts(StringBuilder page, JsonElement report, string section, string caption)
    {
        AppendTable(page, report, section, caption, "<th>Name</th><th>Value</th>",
            fact => $"<th>{Encode(Shown(fact[0]))}</th><td>{Encode(Shown(fact[1]))}</td>");
    }

    static void AppendTable(StringBuilder page, JsonElement report, string section, string caption, string header,
        Func<JsonElement, string> row)
    {
        if (!report.TryGetProperty(section, out var rows) || rows.ValueKind != JsonValueKind.Array || rows.GetArrayLength() == 0)
        {
            page.Append(CultureInfo.InvariantCulture, $"<p>{PlainTexts.NotMeasured(caption)}</p>\n");
            return;
        }
        page.Append(CultureInfo.InvariantCulture, $"<table>\n<caption>{caption}</caption>\n<tr>{header}</tr>\n");
        foreach (var item in rows.EnumerateArray()) page.Append(CultureInfo.InvariantCulture, $"<tr>{row(item)}</tr>\n");
        page.Append("</table>\n");
    }

    static string NumberCell(JsonElement row, string name)
    {
        var value = row.TryGetProperty(name, out var number) && number.ValueKind == JsonValueKind.Number
            ? number.GetDouble().ToString("G4", CultureInfo.InvariantCulture)
            : "–";
        return $"<td class=\"n\">{value}</td>";
    }

    static string Text(JsonElement element, string name)
    {
        return element.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.String ? value.GetString() : null;
    }

    static string Shown(JsonElement value) => value.ValueKind == JsonValueKind.Null ? "–" : value.ToString();

    static string Encode(string text) => WebUtility.HtmlEncode(text ?? "");
}
