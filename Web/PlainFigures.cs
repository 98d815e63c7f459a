using System.Globalization;
using System.Net;
using System.Text;
using System.Text.Json;

namespace Nowpose.Web;

/// <summary>The paper's figures without plots and without JavaScript, for builds on machines that have no Node.js.</summary>
public static class PlainFigures
{
    // Drawings use the page's colours by name, so they are given here as well.
    const string Style = "body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;color-scheme:light;"
        + "--truth:#b9c2cc;--hold:#d9741a;--adaptive:#0b4a8f;--quadratic:#00856f;--ink:#16202c;--muted:#55616f;--surface:#fff}"
        + "table{border-collapse:collapse;margin:1rem 0}caption{font-weight:600;text-align:left}svg{width:20rem;max-width:100%}"
        + "th,td{padding:.25rem 1rem .25rem 0;border-bottom:1px solid #8886;text-align:left}";

    /// <param name="page">As <see cref="FiguresPage.Render"/> takes it.</param>
    public static string Render(JsonElement page)
    {
        var html = new StringBuilder();
        var title = Text(page, "title");
        Append(html, $"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
        Append(html, $"<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n");
        Append(html, $"<title>{title}</title>\n<style>{Style}</style>\n</head>\n<body>\n<h1>{title}</h1>\n<p>{Text(page, "subtitle")}</p>\n");
        Table(html, "Conditions", ["Condition", "Value"], Items(page, "conditions").Select(Cells));
        foreach (var figure in Items(page, "figures")) Figure(html, figure);
        return html.Append("<p>This page has no plots: Nowpose was built without Node.js. Install Node.js 18 or newer with npm, ")
            .Append("build again, and the next page has them.</p>\n</body>\n</html>\n").ToString();
    }

    static void Figure(StringBuilder html, JsonElement figure)
    {
        var number = Text(figure, "number");
        Append(html, $"<h2>Fig. {number}: {Text(figure, "title")}</h2>\n<p>The paper: {Text(figure, "claim")}</p>\n");
        Append(html, $"<p>Verdict: <strong>{Text(figure, "verdict")}</strong>. {Text(figure, "beyond")}</p>\n");
        Table(html, "What decides", ["Criterion", "Measured", "Met"], Items(figure, "criteria").Select(
            c => (IEnumerable<string>)[Text(c, "statement"), Text(c, "measured"), c.GetProperty("is_met").GetBoolean() ? "yes" : "no"]));
        foreach (var drawing in Items(figure, "drawings"))
            Append(html, $"<figure>{drawing.GetProperty("svg").GetString()}<figcaption>{Text(drawing, "title")}. {Text(drawing, "description")}</figcaption></figure>\n");
        if (figure.TryGetProperty("summary", out var summary) && summary.ValueKind == JsonValueKind.Object)
            Table(html, Text(summary, "caption"), Cells(summary.GetProperty("columns")), Items(summary, "rows").Select(Cells));
        Append(html, $"<p>{Text(figure, "conditions")}</p>\n");
        if (!figure.TryGetProperty("table", out var table)) return;
        Append(html, $"<details><summary>Data, as in {Text(figure, "file")}</summary>\n");
        Table(html, $"Data of Fig. {number}", Cells(table.GetProperty("columns")), Items(table, "rows").Select(Cells));
        html.Append("</details>\n");
    }

    static void Table(StringBuilder html, string caption, IEnumerable<string> header, IEnumerable<IEnumerable<string>> rows)
    {
        Append(html, $"<table>\n<caption>{caption}</caption>\n<tr>{string.Concat(header.Select(h => $"<th>{h}</th>"))}</tr>\n");
        foreach (var row in rows) Append(html, $"<tr>{string.Concat(row.Select(cell => $"<td>{cell}</td>"))}</tr>\n");
        html.Append("</table>\n");
    }

    static JsonElement.ArrayEnumerator Items(JsonElement element, string name) =>
        element.TryGetProperty(name, out var items) && items.ValueKind == JsonValueKind.Array ? items.EnumerateArray() : default;

    static IEnumerable<string> Cells(JsonElement row) => row.EnumerateArray().Select(cell => WebUtility.HtmlEncode(cell.ToString()));

    static string Text(JsonElement element, string name) =>
        element.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.String ? WebUtility.HtmlEncode(value.GetString()) : "";

    static void Append(StringBuilder html, FormattableString text) => html.Append(text.ToString(CultureInfo.InvariantCulture));
}
