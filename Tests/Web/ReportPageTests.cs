using System.Text.Json;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Nowpose.Web;

namespace Nowpose.Headless.Tests.Web;

public sealed class ReportPageTests
{
    const string Opening = "<script type=\"application/json\" id=\"report-data\">";

    [SetUp]
    public void SetUp()
    {
        Needs.BuiltByNode(Pages.Report.HasPlots);
    }

    [Test]
    public void Render_AnyData_RoundTrips()
    {
        const string Json = "{\"title\":\"a < b & c > d\",\"settings\":[[\"ü\",1.5],[\"n\",null]],\"error\":{\"t\":[0,0.1]}}";

        var data = DataOf(Pages.Report.Render(Json));

        Assert.That(JsonElement.DeepEquals(data, JsonDocument.Parse(Json).RootElement), data.ToString());
    }

    [TestCase("</script><script>alert(1)</script>")]
    [TestCase("<!--<script>")]
    [TestCase("__REPORT_DATA__")]
    public void Render_HostileTitle_StaysInsideTheDataElement(string title)
    {
        var harmless = Pages.Report.Render("{\"title\":\"x\"}");

        var page = Pages.Report.Render(JsonSerializer.Serialize(new { title }, Unescaped));

        Assert.That(DataOf(page).GetProperty("title").GetString(), Is.EqualTo(title));
        Assert.That(Count(page, "<script"), Is.EqualTo(Count(harmless, "<script")));
        Assert.That(Count(page, "</script"), Is.EqualTo(Count(harmless, "</script")));
        Assert.That(Count(page, "<!--"), Is.EqualTo(Count(harmless, "<!--")));
    }

    [Test]
    public void Render_AnyData_LeavesNoPlaceholder()
    {
        Assert.That(Pages.Report.Render("{}"), Does.Not.Contain("__REPORT_DATA__").And.Not.Contain("/*SCRIPT*/").And.Not.Contain("/*STYLE*/"));
    }

    [Test]
    public void Render_AnyData_HasNoExternalReferences()
    {
        var page = Pages.Report.Render("{}");

        Assert.That(page, Does.Contain("default-src 'none'"));
        // Checks only the styles. Scripts contain calls such as new URL(…), and the content security policy prevents requests from them.
        var outside = Regex.Match(page, @"(?i)<script[^>]+src|<link[^>]+stylesheet|@import|(?-i:\burl\((?!data:))");
        Assert.That(outside.Value, Is.Empty);
    }

    static readonly JsonSerializerOptions Unescaped = new()
    {
        Encoder = System.Text.Encodings.Web.JavaScriptEncoder.UnsafeRelaxedJsonEscaping,
    };

    static JsonElement DataOf(string page)
    {
        var start = page.IndexOf(Opening, StringComparison.Ordinal) + Opening.Length;
        var end = page.IndexOf("</script>", start, StringComparison.Ordinal);
        return JsonDocument.Parse(page[start..end]).RootElement;
    }

    static int Count(string text, string part) => text.Split(part).Length - 1;
}
