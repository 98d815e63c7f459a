using System.Text.Json;
using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Web;

public sealed class PlainReportTests
{
    [Test]
    public void Render_PlainPage_HasTables()
    {
        var page = Render("""
            {"title": "A run", "subtitle": "20 s",
             "summary": [{"label": "RMS", "unit": "mm", "uncompensated": 14.25, "compensated": null}],
             "facts": [["frames", 1200], ["drift", null]], "settings": [["network", "wifi"]]}
            """);

        Assert.That(page, Does.Contain("<h1>A run</h1>").And.Contain("<p>20 s</p>").And.Not.Contain("<script"));
        Assert.That(page, Does.Contain("<td>RMS (mm)</td><td>14.25</td><td>–</td>"));
        Assert.That(page, Does.Contain("<td>frames</td><td>1200</td>").And.Contain("<td>drift</td><td>–</td>"));
        Assert.That(page, Does.Contain("<td>network</td><td>wifi</td>"));
    }

    [TestCase("holds")]
    [TestCase("not measured")]
    public void Render_Claims_HasNumbersAndVerdicts(string verdict)
    {
        var page = Render($$"""{"claims": [{"figure": "18", "claim": "L < 4 ms", "paper": "4 ms", "measured": "1.5 ms", "verdict": "{{verdict}}"}]}""");

        Assert.That(page, Does.Contain($"<td>Fig. 18</td><td>L &lt; 4 ms</td><td>4 ms</td><td>1.5 ms</td><td>{verdict}</td>"));
    }

    [TestCase("{}")]
    [TestCase("{\"summary\": null, \"facts\": [], \"settings\": null}")]
    public void Render_SectionMissing_StatesNotMeasured(string json)
    {
        var page = Render(json);

        Assert.That(page, Does.Contain("<h1>Nowpose report</h1>"));
        Assert.That(page.Split("not measured in this run").Length - 1, Is.EqualTo(3));
    }

    [Test]
    public void Render_HostileText_IsEscaped()
    {
        const string Hostile = "</td><script>alert(1)</script>";
        var json = JsonSerializer.Serialize(new
        {
            title = Hostile,
            subtitle = Hostile,
            summary = new[] { new { label = Hostile, unit = Hostile, uncompensated = 1, compensated = 2 } },
            facts = new[] { new[] { Hostile, Hostile } },
        });

        Assert.That(Render(json), Does.Not.Contain("<script").And.Contain("&lt;/td&gt;&lt;script&gt;"));
    }

    [Test]
    public void Render_BuiltWithoutNode_SuggestsInstallingNode()
    {
        Assert.That(Render("{}"), Does.Contain("Install Node.js 20 or newer"));
    }

    static string Render(string json)
    {
        using var data = JsonDocument.Parse(json);
        return PlainReport.Render(data.RootElement);
    }
}
