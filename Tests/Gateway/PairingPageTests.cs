using System.Net;
using System.Text;
using System.Text.Json;
using Microsoft.AspNetCore.Http;
using Nowpose.Gateway.Messages;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Headless.Tests.Cli;
using Nowpose.Pairing;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the access to the pairing page and its code. Web/test checks the drawing in a browser.</summary>
public sealed class PairingPageTests
{
    [Test]
    public async Task Page_RequestedFromThisMachine_ContainsNoSecret()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();

        var (status, page) = await gateway.SendAsync(HttpMethod.Get, "/pair");

        Needs.BuiltByNode(Nowpose.Web.Pages.Pairing != null);
        Assert.That(status, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(page, Does.Contain("connect-src 'self'").And.Not.Contain(code.Token));
        Assert.That(gateway.Server.PairingPageUri, Is.EqualTo(new Uri($"https://127.0.0.1:{gateway.Server.WebSocketEndPoint.Port}/pair")));
    }

    [TestCase("GET", "/pair")]
    [TestCase("POST", "/pair/code")]
    [TestCase("POST", "/pair/cell")]
    public async Task Request_WithAnotherHostName_Returns403(string method, string path)
    {
        await using var gateway = await PairingGateway.StartAsync();
        using var body = new StringContent("{}");

        // With DNS rebinding, a page of another site, whose host name has been redirected to this machine, sends such a request.
        var (status, text) = await gateway.SendAsync(new HttpMethod(method), path, method == "POST" ? body : null, ("Host", "evil.example"));

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden));
        Assert.That(text, Does.Contain(PairingServiceMessages.ThisMachineOnly));
    }

    [TestCase("10.0.0.9", "10.0.0.7", null, 403)]
    [TestCase("10.0.0.9", "10.0.0.7", Gateways.ObserverToken, 403)]
    [TestCase("10.0.0.9", "10.0.0.7", Gateways.SourceToken, 403)]
    [TestCase("10.0.0.9", "10.0.0.7", Gateways.OperatorToken, 200)]
    // rootless Podman with published ports: every client has the address of the container.
    [TestCase("10.0.2.100", "10.0.2.100", null, 403)]
    [TestCase("10.0.2.100", "10.0.2.100", Gateways.OperatorToken, 200)]
    [TestCase("127.0.0.1", "127.0.0.1", null, 200)]
    [TestCase("::ffff:10.0.0.9", "::ffff:10.0.0.7", null, 403)]
    [TestCase("::1", "::1", null, 200)]
    public async Task Code_RequestedByAClient_IsReturnedOnlyToLoopbackAndOperators(string remote, string local, string token, int expected)
    {
        using var folder = new TemporaryFile("");
        var options = Gateways.Options() with { Headsets = new HeadsetList(folder.Path), Tokens = Gateways.Tokens };
        var address = IPAddress.Parse(local);
        var plain = address.IsIPv4MappedToIPv6 ? address.MapToIPv4() : address;
        var context = Request("/pair/code", token, new IPEndPoint(plain, 47011).ToString());
        context.Connection.RemoteIpAddress = IPAddress.Parse(remote);
        context.Connection.LocalIpAddress = address;

        await Routes(options).ServeAsync(context, _ => throw new InvalidOperationException("handed on")).Bounded();

        Assert.That(context.Response.StatusCode, Is.EqualTo(expected));
        Assert.That(BodyOf(context).Contains("nowpose:token"), Is.EqualTo(expected == 200));
    }

    [TestCase("0.0.0.0", PairingServiceMessages.ThisMachineOnly)]
    [TestCase("10.0.0.7", PairingServiceMessages.OperatorsOnly)]
    public async Task Refusal_OfTheGatewaysAddress_NamesLocalhostOnlyIfTheGatewayListensThere(string bind, string expected)
    {
        using var folder = new TemporaryFile("");
        var options = Gateways.Options() with { Headsets = new HeadsetList(folder.Path), Bind = IPAddress.Parse(bind) };
        var context = Request("/pair/code", null, "10.0.0.7:47011");
        context.Connection.RemoteIpAddress = context.Connection.LocalIpAddress = IPAddress.Parse("10.0.0.7");

        await Routes(options).ServeAsync(context, _ => throw new InvalidOperationException("handed on")).Bounded();

        Assert.That(BodyOf(context), Does.StartWith(expected));
    }

    static PairingRoutes Routes(GatewayOptions options)
    {
        var counters = new ConnectionCounters();
        return new(options, new AccessControl(options, new WrongTokens(options.Time), counters, (_, _) => { }), counters, _ => { }, html: null);
    }

    static DefaultHttpContext Request(string path, string token, string host)
    {
        var context = new DefaultHttpContext { Response = { Body = new MemoryStream() } };
        context.Request.Method = "POST";
        context.Request.Path = path;
        context.Request.Host = new HostString(host);
        if (token != null) context.Request.Headers.Authorization = "Bearer " + token;
        context.Request.ContentLength = 2;
        context.Request.Body = new MemoryStream("{}"u8.ToArray());
        context.Connection.RemoteIpAddress = IPAddress.Parse("10.0.0.9");
        return context;
    }

    static string BodyOf(HttpContext context) => Encoding.UTF8.GetString(((MemoryStream)context.Response.Body).ToArray());

    [Test]
    public async Task Code_ForeignPage_Returns403()
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (status, _) = await gateway.PostAsync("/pair/code", "{}", ("Origin", "https://evil.example"));

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden));
    }

    [TestCase("GET", "/pair/code", HttpStatusCode.MethodNotAllowed)]
    [TestCase("DELETE", "/pair", HttpStatusCode.MethodNotAllowed)]
    [TestCase("GET", "/pair/else", HttpStatusCode.NotFound)]
    [TestCase("GET", "/pairs", HttpStatusCode.Unauthorized)]
    public async Task Request_OtherMethodOrPath_IsRefused(string method, string path, HttpStatusCode expected)
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (status, _) = await gateway.SendAsync(new HttpMethod(method), path);

        Assert.That(status, Is.EqualTo(expected));
    }

    [Test]
    public async Task Code_GatewayWithTls_ContainsTheKeyThatAHeadsetShows()
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (_, text) = await gateway.PostAsync("/pair/code", "{}");

        var key = JsonDocument.Parse(text).RootElement.GetProperty("key").GetString();
        Assert.That(key, Has.Length.EqualTo(13).And.EndsWith("…"));
        var flow = new PairingFlow(PairedCells.None, "headset 7", (_, _, _) => throw new InvalidOperationException("the wearer has not agreed"));
        flow.See(gateway.CellCode().Text, HeadsetTime.FromSeconds(10));
        Assert.That(flow.Question, Does.EndWith("key " + key));
    }

    [Test]
    public async Task Cell_WithOffset_ReturnsAReadableCode()
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (_, begin) = await gateway.PostAsync("/pair/cell", "{}");
        var (_, made) = await gateway.PostAsync(
            "/pair/cell", "{\"name\":\"Press 3\",\"host\":\"10.0.0.7\",\"offset\":\"0.25,-0.1,0,0,0,90\",\"size_mm\":\"120\"}");

        Assert.That(JsonDocument.Parse(begin).RootElement.GetProperty("name").GetString(), Is.EqualTo("press"));
        Assert.That(JsonDocument.Parse(begin).RootElement.GetProperty("hosts")[0].GetString(), Is.EqualTo("127.0.0.1"));
        var code = CellCode.Parse(JsonDocument.Parse(made).RootElement.GetProperty("text").GetString());
        Assert.That(code.Pin, Is.EqualTo(gateway.Server.Pin));
        Assert.That(code.SyncPort, Is.EqualTo(gateway.Server.SyncEndPoint.Port));
        Assert.That(code.WebSocketPort, Is.EqualTo(gateway.Server.WebSocketEndPoint.Port));
        Assert.That(code.Marker.ToString(), Is.EqualTo("0.25,-0.1,0,0,0,90"));
        Assert.That(code.SizeMetres, Is.EqualTo(0.12));
    }

    // A machine with several network cards: the headsets' network is probably the one in which the page is open.
    [TestCase("192.168.20.7:47011", "192.168.20.7")]
    [TestCase("[fd00::7]:47011", "fd00::7")]
    [TestCase("edge1.plant.example:47011", "edge1.plant.example")]
    [TestCase("localhost:47011", null)]
    [TestCase("127.0.0.1:47011", null)]
    [TestCase("[::1]:47011", null)]
    public async Task Cell_Begun_ProposesFirstTheHostAtWhichThePageIsOpen(string opened, string proposed)
    {
        using var folder = new TemporaryFile("");
        using var certificate = CertificateFiles.Generate();
        var options = Gateways.Options() with
        {
            Bind = IPAddress.Any,
            Certificate = certificate,
            Headsets = new HeadsetList(folder.Path),
            Tokens = Gateways.Tokens,
        };
        var context = Request("/pair/cell", Gateways.OperatorToken, opened);

        await Routes(options).ServeAsync(context, _ => throw new InvalidOperationException("handed on")).Bounded();

        var hosts = JsonDocument.Parse(BodyOf(context)).RootElement.GetProperty("hosts").EnumerateArray().Select(host => host.GetString()).ToArray();
        var reachable = OwnHosts.Reachable(IPAddress.Any).ToArray();
        Assert.That(hosts[0], Is.EqualTo(proposed ?? reachable[0]));
        Assert.That(hosts, Is.SupersetOf(reachable).And.Unique);
    }

    [TestCase("{\"name\":\"\",\"host\":\"10.0.0.7\",\"size_mm\":\"120\"}", "name")]
    [TestCase("{\"name\":\"a\",\"host\":\"10.0.0\",\"size_mm\":\"120\"}", "host")]
    [TestCase("{\"name\":\"a\",\"host\":\"10.0.0.7\",\"size_mm\":\"x\"}", "size")]
    [TestCase("{\"name\":\"a\",\"host\":\"10.0.0.7\",\"size_mm\":\"0\"}", "size")]
    [TestCase("{\"name\":\"a\",\"host\":\"10.0.0.7\",\"size_mm\":\"120\",\"offset\":\"1,2\"}", "offset")]
    public async Task Cell_InvalidInput_IsReportedInOneLine(string body, string part)
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (_, text) = await gateway.PostAsync("/pair/cell", body);

        Assert.That(JsonDocument.Parse(text).RootElement.GetProperty("fault").GetString(), Does.Contain(part));
    }
}
