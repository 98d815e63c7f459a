using System.Globalization;
using System.Net;
using System.Net.Http.Headers;
using System.Text;
using System.Text.Json;
using Microsoft.AspNetCore.Http;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Codes;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the page with the control clock's code, and its requests for the time. Web/test checks the drawing in a browser.</summary>
public class VlcPageTests
{
    const string TimeRequest = "POST /vlc/time";
    const string Empty = "Content-Length: 0\r\n";

    static async Task<HttpResponseMessage> AskAsync(
        GatewayServer gateway, HttpMethod method, string path, string origin = null, string token = null)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(method, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}"));
        if (origin != null) request.Headers.Add("Origin", origin.Replace("{port}", gateway.WebSocketEndPoint.Port.ToString()));
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        return await http.SendAsync(request).Bounded();
    }

    [Test]
    public async Task Page_Requested_HasNoExternalRequestsAndNoSecrets()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });

        using var response = await AskAsync(gateway, HttpMethod.Get, "/vlc");
        var page = await response.Content.ReadAsStringAsync().Bounded();

        Needs.BuiltByNode(Nowpose.Web.Pages.Vlc != null);
        Assert.That(response.StatusCode, Is.EqualTo(HttpStatusCode.OK), "a browser that opens the page has no token");
        Assert.That(response.Content.Headers.ContentType.MediaType, Is.EqualTo("text/html"));
        Assert.That(page, Does.Contain("connect-src 'self'").And.Not.Contain(Gateways.ObserverToken).And.Not.Contain("https://"));
        Assert.That(gateway.VlcPageUris, Is.EqualTo(new[] { new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/vlc") }));
    }

    [Test]
    public async Task Page_ManyKeepAliveClients_ClosesTheirConnections()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawWebSocket.ConnectAsync(gateway);
        using var second = await RawWebSocket.ConnectAsync(gateway);

        Assert.That(await first.RequestAsync(request: "GET /vlc"), Does.Contain("Connection: close"));
        Assert.That(await second.RequestAsync(request: "GET /vlc"), Does.Contain("Connection: close"));
        await first.ExpectEndAsync();
        await second.ExpectEndAsync();

        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Page_NotBuilt_Returns503WithTheRemedyInOneLine()
    {
        var counters = new ConnectionCounters();
        var accessControl = new AccessControl(Gateways.Options(), new WrongTokens(TimeProvider.System), counters, (_, _) => { });
        var page = new VlcPage(Gateways.Options(), new StopwatchControlClock(Gateways.Start), accessControl, counters, html: null);
        var context = new DefaultHttpContext { Request = { Method = "GET", Path = "/vlc" }, Response = { Body = new MemoryStream() } };

        await page.ServeAsync(context, _ => throw new InvalidOperationException("handed on")).Bounded();

        Assert.That(context.Response.StatusCode, Is.EqualTo(503));
        var text = Encoding.UTF8.GetString(((MemoryStream)context.Response.Body).ToArray());
        Assert.That(text.TrimEnd().Split('\n'), Has.Length.EqualTo(1));
        Assert.That(text, Does.Contain(OperationsMessages.PageMissing));
    }

    [Test]
    public async Task Page_ForeignOrigin_Returns403()
    {
        await using var gateway = await Gateways.StartAsync();

        using var response = await AskAsync(gateway, HttpMethod.Get, "/vlc", "http://evil.example");

        Assert.That(response.StatusCode, Is.EqualTo(HttpStatusCode.Forbidden));
    }

    [Test]
    public async Task Time_Requested_IsBetweenRequestAndAnswer()
    {
        var clock = new StopwatchControlClock(Gateways.Start) { Resolution = TimeSpan.FromMicroseconds(250), IsSynchronised = false };
        await using var gateway = await Gateways.StartAsync(clock: clock);
        var before = clock.Now.Nanoseconds;

        using var response = await AskAsync(gateway, HttpMethod.Post, "/vlc/time", "http://localhost:{port}");
        var answer = JsonDocument.Parse(await response.Content.ReadAsStringAsync().Bounded()).RootElement;

        var (received, sent) = (Nanoseconds(answer, "t2_ns"), Nanoseconds(answer, "t3_ns"));
        Assert.That(received, Is.InRange(before, sent));
        Assert.That(sent, Is.InRange(received, clock.Now.Nanoseconds));
        Assert.That(answer.GetProperty("resolution_ns").GetInt64(), Is.EqualTo(250_000));
        Assert.That(answer.GetProperty("is_synchronised").GetBoolean(), Is.False);
    }

    [TestCase("http://evil.example")]
    [TestCase("null")]
    [TestCase("http://127.0.0.1:1")]
    public async Task Time_ForeignOrigin_Returns403(string origin)
    {
        await using var gateway = await Gateways.StartAsync();

        using var response = await AskAsync(gateway, HttpMethod.Post, "/vlc/time", origin);

        Assert.That(response.StatusCode, Is.EqualTo(HttpStatusCode.Forbidden));
        Assert.That(gateway.WebSocketConnections[Closure.Origin], Is.EqualTo(1));
    }

    [TestCase(null, HttpStatusCode.Unauthorized)]
    [TestCase("guess", HttpStatusCode.Unauthorized)]
    [TestCase(Gateways.ObserverToken, HttpStatusCode.OK)]
    public async Task Time_GatewayWithTokens_RequiresAToken(string token, HttpStatusCode status)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });

        using var response = await AskAsync(gateway, HttpMethod.Post, "/vlc/time", token: token);

        Assert.That(response.StatusCode, Is.EqualTo(status));
    }

    [Test]
    public async Task Time_TooManyConnections_IsRefusedUntilAConnectionEnds()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { MaxConnections = 1 });
        using var first = await RawWebSocket.ConnectAsync(gateway);
        using var second = await RawWebSocket.ConnectAsync(gateway);

        Assert.That(await first.RequestAsync(Empty, TimeRequest), Does.StartWith("HTTP/1.1 200 "));
        Assert.That(await second.RequestAsync(Empty, TimeRequest), Does.StartWith("HTTP/1.1 503 ").And.Contain("Connection: close"));
        first.Dispose();
        await Soon.BecomesAsync(() => gateway.WebSocketConnections.Open == 0, "no longer counted");

        using var client = await RawRosbridgeClient.ConnectAsync(gateway);
        await client.RoundTripAsync();
        Assert.That(gateway.WebSocketConnections[Closure.ConnectionLimit], Is.EqualTo(1));
    }

    [Test]
    public async Task Time_RequestedAboveTheSyncRate_IsRefusedAndTheConnectionEnds()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { SyncRequestsPerSecond = 1 });
        using var hasty = await RawWebSocket.ConnectAsync(gateway);

        // Sends both requests together, so that they are less than a second apart even on a busy machine.
        var request = $"{TimeRequest} HTTP/1.1\r\nHost: localhost\r\n{Empty}\r\n";
        await hasty.SendAsync(Encoding.ASCII.GetBytes(request + request));

        Assert.That(await hasty.ReadToEndAsync(), Does.Match("(?s)^HTTP/1.1 200 .*HTTP/1.1 429 .*Connection: close"));
        await Soon.BecomesAsync(
            () => gateway.WebSocketConnections[Closure.TooManyRequests] == 1 && gateway.WebSocketConnections.Open == 0, "closed and counted");
    }

    [Test]
    public async Task Time_UnknownHostName_AnswersWithTheHostNamesOfTheGateway()
    {
        await using var gateway = await Gateways.StartAsync();

        using var response = await AskAsync(gateway, HttpMethod.Post, "/vlc/time", "http://alias.example:{port}");
        var text = await response.Content.ReadAsStringAsync().Bounded();

        var port = gateway.WebSocketEndPoint.Port;
        Assert.That(text, Does.Contain($"http://127.0.0.1:{port}, http://localhost:{port}, http://{Environment.MachineName}:{port}"));
    }

    [TestCase("/vlc", "POST", "GET")]
    [TestCase("/vlc/time", "GET", "POST")]
    public async Task Request_OtherMethod_AnswersWithTheAllowedMethod(string path, string method, string allowed)
    {
        await using var gateway = await Gateways.StartAsync();

        using var response = await AskAsync(gateway, new HttpMethod(method), path);

        Assert.That(response.StatusCode, Is.EqualTo(HttpStatusCode.MethodNotAllowed));
        Assert.That(response.Content.Headers.Allow, Does.Contain(allowed));
    }

    [Test]
    public async Task WebSocket_OnThePagesPath_IsServed()
    {
        await using var gateway = await Gateways.StartAsync();
        using var socket = new System.Net.WebSockets.ClientWebSocket();

        await socket.ConnectAsync(new Uri(gateway.WebSocketUri(), "vlc"), default).Bounded();

        Assert.That(socket.State, Is.EqualTo(System.Net.WebSockets.WebSocketState.Open));
    }

    static long Nanoseconds(JsonElement answer, string name) => long.Parse(answer.GetProperty(name).GetString(), CultureInfo.InvariantCulture);
}
