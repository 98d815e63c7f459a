using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Web;

public sealed class FiguresPageTests
{
    [SetUp]
    public void SetUp()
    {
        Needs.BuiltByNode(Pages.Figures.HasPlots);
    }

    [Test]
    public void Render_Data_EmbedsItInThePage()
    {
        var page = Pages.Figures.Render("{\"title\":\"a < b\",\"figures\":[]}");

        Assert.That(page, Does.Contain("{\"title\":\"a \\u003c b\",\"figures\":[]}").And.Contain("<title>Nowpose figures</title>"));
        Assert.That(page, Does.Not.Contain("__REPORT_DATA__").And.Not.Contain("/*SCRIPT*/").And.Not.Contain("/*STYLE*/"));
    }

    [Test]
    public void Render_AnyData_HasNoExternalReferences()
    {
        var page = Pages.Figures.Render("{}");

        Assert.That(page, Does.Contain("default-src 'none'"));
        Assert.That(page, Does.Not.Match("(?i)<script[^>]+src|<link[^>]+stylesheet|@import|url\\((?!data:)"));
    }
}
