using System.Text.Json;
using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Web;

public sealed class CalibrationPageTests
{
    const string Data = """
        {"title": "L_visu <by eye>", "result": "L_visu is 46 ms.", "warnings": ["limit not reached"], "facts": [["L_visu", "46 ms"]],
         "sections": [{"heading": "Offset", "source": null, "words": "The slope.", "plots": [], "table": {"columns": ["v", "mm"], "rows": [[250, 1.5], [-250, null]]}}]}
        """;

    [Test]
    public void Render_Data_MakesNoExternalRequests()
    {
        Needs.BuiltByNode(Pages.Calibration.HasPlots);

        var page = Pages.Calibration.Render("{\"title\":\"a < b\"}");

        Assert.That(page, Does.Contain("{\"title\":\"a \\u003c b\"}").And.Contain("<title>Nowpose calibration</title>").And.Contain("default-src 'none'"));
        Assert.That(page, Does.Not.Contain("__REPORT_DATA__").And.Not.Match("(?i)<script[^>]+src|<link[^>]+stylesheet|@import|url\\((?!data:)"));
    }

    [Test]
    public void Render_PlainPage_HasResultWarningFactsAndNumbers()
    {
        using var data = JsonDocument.Parse(Data);

        var page = PlainCalibration.Render(data.RootElement);

        Assert.That(page, Does.Contain("<h1>L_visu &lt;by eye&gt;</h1>").And.Contain("<strong>L_visu is 46 ms.</strong>").And.Contain("limit not reached"));
        Assert.That(page, Does.Contain("<td>L_visu</td><td>46 ms</td>").And.Contain("<td>250</td><td>1.5</td>").And.Contain("built without Node.js"));
        Assert.That(page, Does.Not.Contain("<script"));
    }
}
