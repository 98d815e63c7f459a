using System.Net;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Status.StatusRequests;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Tests the access to the routes that monitoring reads.</summary>
public class StatusRoutesTests
{
    static readonly string[] OpenToAll = ["/healthz", "/readyz"];

    [TestCase("/operations")]
    [TestCase("/operations/state")]
    [TestCase("/metrics")]
    [TestCase("/vlc")]
    [TestCase("/")]
    public async Task Request_ForeignOrigin_ReceivesOnlyTheHealthState(string path)
    {
        await using var gateway = await Gateways.StartAsync();

        var (status, text, _) = await GetAsync(gateway, path, origin: "http://evil.example");

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden), text);
        foreach (var word in OpenToAll)
            Assert.That((await GetAsync(gateway, word, origin: "http://evil.example")).Text, Does.Match("^(live|ready|waiting)\n$"));
    }

    [TestCase("/operations/state", null, HttpStatusCode.Unauthorized)]
    [TestCase("/operations/state", "guess", HttpStatusCode.Unauthorized)]
    [TestCase("/operations/state", Gateways.ObserverToken, HttpStatusCode.OK)]
    [TestCase("/metrics", null, HttpStatusCode.Unauthorized)]
    [TestCase("/metrics", Gateways.ObserverToken, HttpStatusCode.OK)]
    [TestCase("/healthz", null, HttpStatusCode.OK)]
    [TestCase("/readyz", null, HttpStatusCode.OK)]
    public async Task Request_WithOrWithoutToken_ReturnsOnlyHealthWithoutAValidToken(string path, string token, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });

        var (status, text, _) = await GetAsync(gateway, path, token);

        Assert.That(status, Is.EqualTo(expected));
        if (OpenToAll.Contains(path)) Assert.That(text.Trim(), Is.EqualTo("live").Or.EqualTo("ready"));
    }

    [TestCase("/operations/state", "evil.example", HttpStatusCode.Forbidden)]
    [TestCase("/metrics", "evil.example", HttpStatusCode.Forbidden)]
    [TestCase("/metrics", "localhost", HttpStatusCode.OK)]
    public async Task Request_HostNameRedirectedToThisMachine_IsRefused(string path, string host, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await GetAsync(gateway, path, host: host)).Status, Is.EqualTo(expected));
    }

    [TestCase("/operations/state")]
    [TestCase("/metrics")]
    [TestCase("/healthz")]
    [TestCase("/readyz")]
    public async Task Request_MethodNotAllowed_IsRefused(string path)
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await GetAsync(gateway, path, method: HttpMethod.Post)).Status, Is.EqualTo(HttpStatusCode.MethodNotAllowed));
    }
}
