using System.Text.Json;
using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Web;

public sealed class PlainFiguresTests
{
    [Test]
    public void Render_Figure_HasClaimVerdictCriteriaAndDrawing()
    {
        var page = Render("""
            {"title": "Figures", "subtitle": "recomputed", "conditions": [["Seed", "1"]],
             "figures": [{"number": "17", "title": "The arm", "claim": "It is plain to see.", "verdict": "holds partly", "beyond": null,
               "criteria": [{"statement": "Less than half", "is_met": true, "measured": "2 mm"}, {"statement": "None", "is_met": false, "measured": "1 mm"},
                 {"statement": "A third", "is_met": null, "is_undecided": true, "measured": "2 to 4 mm"}, {"statement": "Half", "is_met": null, "measured": "too short"}],
               "conditions": "At rest.", "file": "figure-17.csv", "table": {"columns": ["time (ms)", "gap (mm)"], "rows": [[308.5, 6.9], [707, null]]},
               "summary": {"caption": "Gaps", "columns": ["At", "mm"], "rows": [["A", "2.09"]]},
               "drawings": [{"title": "A", "description": "78 mm off", "svg": "<svg viewBox=\"0 0 1 1\"></svg>"}]}]}
            """);

        Assert.That(page, Does.Contain("<h2>Fig. 17: The arm</h2>").And.Contain("<strong>holds partly</strong>").And.Not.Contain("<script"));
        Assert.That(page, Does.Contain("<td>Less than half</td><td>2 mm</td><td>yes</td>").And.Contain("<td>None</td><td>1 mm</td><td>no</td>"));
        Assert.That(page, Does.Contain("<td>2 to 4 mm</td><td>undecided</td>").And.Contain("<td>too short</td><td>not measured</td>"));
        Assert.That(page, Does.Contain("<svg viewBox=\"0 0 1 1\">").And.Contain("A. 78 mm off").And.Contain("<td>A</td><td>2.09</td>"));
        Assert.That(page, Does.Contain("<th>gap (mm)</th>").And.Contain("<td>308.5</td><td>6.9</td>").And.Contain("<td>707</td><td>–</td>"));
        Assert.That(page, Does.Contain("figure-17.csv").And.Contain("Install Node.js 20 or newer"));
    }

    [Test]
    public void Render_InterruptedRun_NamesTheMissingFigures()
    {
        Assert.That(Render("""{"missing": ["13a", "18"], "figures": []}"""), Does.Contain("Fig. 13a, Fig. 18"));
        Assert.That(Render("""{"missing": [], "figures": []}"""), Does.Not.Contain("role=\"alert\""));
    }

    [Test]
    public void Render_HostileText_IsEscaped()
    {
        const string Hostile = "</td><script>alert(1)</script>";
        var json = JsonSerializer.Serialize(new
        {
            title = Hostile, missing = new[] { Hostile }, conditions = new[] { new[] { Hostile } }, figures = new[] { new { number = Hostile, title = Hostile, claim = Hostile } },
        });

        Assert.That(Render(json), Does.Not.Contain("<script").And.Contain("&lt;/td&gt;&lt;script&gt;"));
    }

    static string Render(string json)
    {
        using var data = JsonDocument.Parse(json);
        return PlainFigures.Render(data.RootElement);
    }
}
