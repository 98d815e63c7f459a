using System.Net;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using Nowpose.Gateway;
using Nowpose.Web;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tests the security headers of all responses.</summary>
public sealed class SecurityHeaderTests : IDisposable
{
    readonly HttpClient _http = new();

    public void Dispose() => _http.Dispose();

    [TestCase("/operations")]
    [TestCase("/vlc")]
    [TestCase("/pair")]
    public async Task Page_Served_AllowsOnlyItsOwnScript(string path)
    {
        Needs.BuiltByNode(Pages.Operations != null);
        using var folder = new TemporaryFolder();
        var headsets = new Nowpose.Gateway.Pairing.HeadsetList(Path.Combine(folder.Path, "headsets.txt"));
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Headsets = headsets });

        using var answer = await GetAsync(gateway, path);
        var page = await answer.Content.ReadAsStringAsync();

        Assert.That(answer.StatusCode, Is.EqualTo(HttpStatusCode.OK));
        var policy = PolicyOf(answer);
        Assert.That(policy, Does.Contain("default-src 'none'").And.Contain("frame-ancestors 'none'"));
        // Style attributes are allowed, because browsers use them to display errors of their XML parser, for example for an invalid URDF.
        Assert.That(policy.Replace("style-src-attr 'unsafe-inline'", ""), Does.Not.Contain("unsafe-inline"));
        Assert.That(ScriptsOf(page).Select(HashOf), Is.EqualTo(new[] { SourceOf(policy, "script-src") }), "the page has only this script");
        Assert.That(SourceOf(policy, "style-src"), Does.StartWith("'sha256-"));
    }

    [TestCase("/operations", HttpStatusCode.OK)]
    [TestCase("/healthz", HttpStatusCode.OK)]
    [TestCase("/metrics", HttpStatusCode.Unauthorized)]
    [TestCase("/nowhere", HttpStatusCode.Unauthorized)]
    public async Task Answer_WithAnyStatus_ForbidsSniffingAndFraming(string path, HttpStatusCode status)
    {
        Needs.BuiltByNode(Pages.Operations != null);
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });

        using var answer = await GetAsync(gateway, path);

        Assert.That(answer.StatusCode, Is.EqualTo(status));
        Assert.That(answer.Headers.GetValues("X-Content-Type-Options"), Is.EqualTo(new[] { "nosniff" }));
        Assert.That(answer.Headers.GetValues("Referrer-Policy"), Is.EqualTo(new[] { "no-referrer" }));
        Assert.That(answer.Headers.GetValues("X-Frame-Options"), Is.EqualTo(new[] { "DENY" }));
        Assert.That(PolicyOf(answer), Does.Contain("default-src 'none'").And.Contain("frame-ancestors 'none'"));
    }

    [Test]
    public void Pages_OpenedFromDisk_AllowOnlyTheirOwnScript()
    {
        Needs.BuiltByNode(Pages.Report.HasPlots);

        foreach (var page in new[] { Pages.Report.Render("{}"), Pages.Figures.Render("{}"), Pages.Calibration.Render("{}") })
        {
            var policy = Regex.Match(page, "http-equiv=\"Content-Security-Policy\"\\s+content=\"([^\"]*)\"").Groups[1].Value;
            // Style attributes are allowed, because the data of these pages contain drawings with style attributes.
            Assert.That(policy.Replace("style-src-attr 'unsafe-inline'", ""), Does.Not.Contain("unsafe-inline"));
            Assert.That(ScriptsOf(page).Select(HashOf), Is.EqualTo(new[] { SourceOf(policy, "script-src") }));
        }
    }

    Task<HttpResponseMessage> GetAsync(GatewayServer gateway, string path) =>
        _http.GetAsync(new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}")).Bounded();

    static string PolicyOf(HttpResponseMessage answer) => answer.Headers.GetValues("Content-Security-Policy").Single();

    static string SourceOf(string policy, string directive) => Regex.Match(policy, directive + " ([^;]*)").Groups[1].Value;

    // Returns the scripts that a browser executes. Data are in script elements with a type.
    static IEnumerable<string> ScriptsOf(string page) =>
        Regex.Matches(page, "<script>(.*?)</script>", RegexOptions.Singleline).Select(match => match.Groups[1].Value);

    static string HashOf(string script) => $"'sha256-{Convert.ToBase64String(SHA256.HashData(Encoding.UTF8.GetBytes(script)))}'";
}
