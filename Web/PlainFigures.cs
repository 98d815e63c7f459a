using System.Text;
using System.Text.Json;
using Nowpose.Web.Messages;
using static Nowpose.Web.PlainPage;

namespace Nowpose.Web;

/// <summary>Creates the page of the paper's figures without plots and JavaScript, for builds without Node.js.</summary>
public static class PlainFigures
{
    // Defines the colours that the drawings refer to by name.
    const string Style = "body{color-scheme:light;--truth:#8a95a0;--hold:#d9741a;--adaptive:#0b4a8f;--quadratic:#00856f;--ink:#16202c;"
        + "--muted:#55616f;--surface:#fff}svg{width:20rem;max-width:100%}";

    /// <param name="page">Data as for <see cref="Pages.Figures"/>.</param>
    public static string Render(JsonElement page)
    {
        var html = Begin(Text(page, "title"), Style);
        Append(html, $"<p>{Text(page, "subtitle")}</p>\n");
        Table(html, "Conditions", ["Condition", "Value"], Items(page, "conditions").Select(Cells));
        var missing = string.Join(", ", Items(page, "missing").Select(number => $"Fig. {Encoded(number)}"));
        if (missing.Length > 0) Append(html, $"<p role=\"alert\">{PlainTexts.NotComputed(missing)}</p>\n");
        foreach (var figure in Items(page, "figures")) Figure(html, figure);
        return End(html);
    }

    static void Figure(StringBuilder html, JsonElement figure)
    {
        var number = Text(figure, "number");
        Append(html, $"<h2>Fig. {number}: {Text(figure, "title")}</h2>\n<p>The paper: {Text(figure, "claim")}</p>\n");
        Append(html, $"<p>Verdict: <strong>{Text(figure, "verdict")}</strong>. {Text(figure, "beyond")}</p>\n");
        Table(html, "What decides", ["Criterion", "Measured", "Met"], Items(figure, "criteria").Select(
            c => (IEnumerable<string>)[Text(c, "statement"), Text(c, "measured"), Met(c)]));
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

    // A criterion that was not measured, or whose value is too uncertain, is neither met nor not met.
    static string Met(JsonElement criterion) => criterion.GetProperty("is_met").ValueKind switch
    {
        JsonValueKind.True => "yes",
        JsonValueKind.False => "no",
        _ => criterion.TryGetProperty("is_undecided", out var undecided) && undecided.ValueKind == JsonValueKind.True ? "undecided" : "not measured",
    };
}
