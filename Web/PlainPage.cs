using System.Globalization;
using System.Net;
using System.Text;
using System.Text.Json;
using Nowpose.Web.Messages;

namespace Nowpose.Web;

/// <summary>Creates parts of pages without plots and JavaScript, for builds without Node.js.</summary>
static class PlainPage
{
    const string Style = "body{font:15px/1.5 system-ui,sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem}"
        + "table{border-collapse:collapse;margin:1rem 0}caption{font-weight:600;text-align:left}"
        + "th,td{padding:.25rem 1rem .25rem 0;border-bottom:1px solid #8886;text-align:left}";

    /// <param name="title">Title, already HTML-encoded.</param>
    /// <param name="style">Style sheet of this page, which is appended to the common one.</param>
    public static StringBuilder Begin(string title, string style)
    {
        var html = new StringBuilder();
        Append(html, $"<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
        Append(html, $"<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n");
        Append(html, $"<title>{title}</title>\n<style>{Style}{style}</style>\n</head>\n<body>\n<h1>{title}</h1>\n");
        return html;
    }

    public static string End(StringBuilder html) =>
        html.Append("<p>").Append(PlainTexts.NoPlots).Append("</p>\n</body>\n</html>\n").ToString();

    public static void Table(StringBuilder html, string caption, IEnumerable<string> header, IEnumerable<IEnumerable<string>> rows)
    {
        Append(html, $"<table>\n<caption>{caption}</caption>\n<tr>{string.Concat(header.Select(h => $"<th>{h}</th>"))}</tr>\n");
        foreach (var row in rows) Append(html, $"<tr>{string.Concat(row.Select(cell => $"<td>{cell}</td>"))}</tr>\n");
        html.Append("</table>\n");
    }

    public static JsonElement.ArrayEnumerator Items(JsonElement element, string name) =>
        element.TryGetProperty(name, out var items) && items.ValueKind == JsonValueKind.Array ? items.EnumerateArray() : default;

    public static IEnumerable<string> Cells(JsonElement row) => row.EnumerateArray().Select(Encoded);

    public static string Encoded(JsonElement value) => value.ValueKind == JsonValueKind.Null ? "–" : WebUtility.HtmlEncode(value.ToString());

    public static string Text(JsonElement element, string name) =>
        element.TryGetProperty(name, out var value) && value.ValueKind == JsonValueKind.String ? Encoded(value) : "";

    public static void Append(StringBuilder html, FormattableString text) => html.Append(text.ToString(CultureInfo.InvariantCulture));
}
