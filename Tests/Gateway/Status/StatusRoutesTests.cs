using System.Net;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.Status.StatusRequests;

namespace Nowpose.Headless.Tests.Gateway.Status;

/// <summary>Access to the gateway's answers to monitoring.</summary>
public class StatusRoutesTests
{
    static readonly string[] OpenToAll = ["/healthz", "/readyz"];

    [TestCase("/operations")]
    [TestCase("/operations/state")]
    [TestCase("/metrics")]
    [TestCase("/vlc")]
    [TestCase("/")]
    public async Task Origin_Foreign_ReceivesOnlyTheHealthState(string path)
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
    public async Task Routes_TokenRequiredButMissing_ReturnOnlyHealth(string path, string token, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });

        var (status, text, _) = await GetAsync(gateway, path, token);

        Assert.That(status, Is.EqualTo(expected));
        if (OpenToAll.Contains(path)) Assert.That(text.Trim(), Is.EqualTo("live").Or.EqualTo("ready"));
    }

    [TestCase("/operations/state", "evil.example", HttpStatusCode.Forbidden)]
    [TestCase("/metrics", "evil.example", HttpStatusCode.Forbidden)]
    [TestCase("/metrics", "localhost", HttpStatusCode.OK)]
    public async Task Routes_ReboundHostName_AreRefused(string path, string host, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await GetAsync(gateway, path, host: host)).Status, Is.EqualTo(expected));
    }

    [TestCase("/operations/state")]
    [TestCase("/metrics")]
    [TestCase("/healthz")]
    [TestCase("/readyz")]
    public async Task Routes_OtherMethods_AreRefused(string path)
    {
        await using var gateway = await Gateways.StartAsync();

        Assert.That((await GetAsync(gateway, path, method: HttpMethod.Post)).Status, Is.EqualTo(HttpStatusCode.MethodNotAllowed));
    }
}
