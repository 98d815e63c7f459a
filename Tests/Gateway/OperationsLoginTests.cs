using System.Net;
using System.Net.WebSockets;
using System.Text;
using System.Text.Json;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the login of a browser, which cannot send the header with the token when it opens pages and WebSockets.</summary>
public sealed class OperationsLoginTests
{
    static readonly GatewayOptions WithTokens = Gateways.Options() with { Tokens = Gateways.Tokens };

    readonly HttpClient _http = new(new SocketsHttpHandler { UseCookies = false });

    [OneTimeTearDown]
    public void TearDown() => _http.Dispose();

    [TestCase(Gateways.ObserverToken, "observer")]
    [TestCase(Gateways.OperatorToken, "operator")]
    public async Task Login_ValidToken_SetsACookieThatOpensAWebSocket(string token, string role)
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);

        using var answer = await LoginAsync(gateway, token);

        Assert.That(await answer.Content.ReadAsStringAsync(), Is.EqualTo($"{{\"role\":\"{role}\"}}"));
        var given = answer.Headers.GetValues("Set-Cookie").Single();
        Assert.That(given.ToLowerInvariant(), Does.Contain("; httponly").And.Contain("; samesite=strict").And.Not.Contain("secure"));
        Assert.That(given, Does.StartWith($"nowpose-{gateway.WebSocketEndPoint.Port}=").And.Not.Contain(token));
        using var client = await RawRosbridgeClient.ConnectAsync(gateway, Cookie(CookieOf(answer)));
        await client.RoundTripAsync();
    }

    [Test]
    public async Task Login_OverTls_SetsASecureCookie()
    {
        await using var gateway = await PairingGateway.StartAsync(tokens: Gateways.Tokens);
        using var request = new StringContent($"{{\"token\":\"{Gateways.OperatorToken}\"}}", Encoding.UTF8, "application/json");

        var given = await gateway.CookieOfAsync("/operations/login", request);

        Assert.That(given.ToLowerInvariant(), Does.Contain("; secure").And.Contain("; httponly"));
    }

    [Test]
    public async Task Request_CookieInvalidOrFromAnotherGateway_Returns401()
    {
        await using var other = await Gateways.StartAsync(WithTokens);
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var answer = await LoginAsync(other, Gateways.ObserverToken);
        var stranger = CookieOf(answer).Replace($"nowpose-{other.WebSocketEndPoint.Port}", $"nowpose-{gateway.WebSocketEndPoint.Port}");

        foreach (var cookie in new[] { stranger, $"nowpose-{gateway.WebSocketEndPoint.Port}=", "" })
            Assert.That(await RosbridgeServerTests.RefusalAsync(gateway, Cookie(cookie)), Is.EqualTo(HttpStatusCode.Unauthorized), cookie);
    }

    [Test]
    public async Task Request_TokenOfTheCookieRevoked_Returns401()
    {
        await using var gateway = await PairingGateway.StartAsync(isSecure: false);
        var token = new HeadsetList(gateway.ListPath).Add("tablet", out _);
        using var answer = await LoginAsync(gateway.Server, token);
        using (var client = await RawRosbridgeClient.ConnectAsync(gateway.Server, Cookie(CookieOf(answer))))
            await client.RoundTripAsync();

        await File.WriteAllTextAsync(gateway.ListPath, "");

        Assert.That(await RosbridgeServerTests.RefusalAsync(gateway.Server, Cookie(CookieOf(answer))), Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [Test]
    public async Task Request_CookieUsedAfterLogout_Returns401()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var answer = await LoginAsync(gateway, Gateways.OperatorToken);

        using var farewell = await PostAsync(gateway, "/operations/logout", "", ("Cookie", CookieOf(answer)));

        Assert.That(farewell.StatusCode, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(farewell.Headers.GetValues("Set-Cookie").Single(), Does.Contain("expires="));
        Assert.That(await RosbridgeServerTests.RefusalAsync(gateway, Cookie(CookieOf(answer))), Is.EqualTo(HttpStatusCode.Unauthorized));
    }

    [Test]
    public async Task Logout_OpenWebSockets_ClosesOnlyTheSocketsOfTheSession()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var answer = await LoginAsync(gateway, Gateways.OperatorToken);
        using var another = await LoginAsync(gateway, Gateways.OperatorToken);
        using var page = await RawRosbridgeClient.ConnectAsync(gateway, Cookie(CookieOf(answer)));
        using var otherPage = await RawRosbridgeClient.ConnectAsync(gateway, Cookie(CookieOf(another)));
        await page.RoundTripAsync();

        using var farewell = await PostAsync(gateway, "/operations/logout", "", ("Cookie", CookieOf(answer)));

        var end = await page.Socket.ReceiveAsync(new byte[100], default).Bounded();
        Assert.That(end.MessageType, Is.EqualTo(WebSocketMessageType.Close));
        Assert.That(page.Socket.CloseStatusDescription, Is.EqualTo("Token"));
        await otherPage.RoundTripAsync();
    }

    [Test]
    public async Task Request_CookieFromAForeignPage_Returns403()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var answer = await LoginAsync(gateway, Gateways.OperatorToken);

        var status = await RosbridgeServerTests.RefusalAsync(gateway, options =>
        {
            Cookie(CookieOf(answer))(options);
            options.SetRequestHeader("Origin", "http://evil.example");
        });
        using var logout = await PostAsync(gateway, "/operations/logout", "", ("Cookie", CookieOf(answer)), ("Origin", "http://evil.example"));

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden));
        Assert.That(logout.StatusCode, Is.EqualTo(HttpStatusCode.Forbidden));
    }

    [Test]
    public async Task State_CookieOrBearer_StatesWhetherTheClientIsALoggedInBrowser()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        using var answer = await LoginAsync(gateway, Gateways.ObserverToken);

        Assert.That(await IsLoggedInAsync("Cookie", CookieOf(answer)), Is.True);
        Assert.That(await IsLoggedInAsync("Authorization", $"Bearer {Gateways.ObserverToken}"), Is.False);

        async Task<bool> IsLoggedInAsync(string header, string value)
        {
            using var request = new HttpRequestMessage(HttpMethod.Get, UriOf(gateway, "/operations/state")) { Headers = { { header, value } } };
            using var state = await _http.SendAsync(request).Bounded();
            return JsonDocument.Parse(await state.Content.ReadAsStringAsync()).RootElement.GetProperty("is_logged_in").GetBoolean();
        }
    }

    [Test]
    public async Task Login_ManyWrongTokens_Returns401ThenBlocks()
    {
        await using var gateway = await Gateways.StartAsync(WithTokens);
        for (var i = 0; i < 10; i++)
        {
            using var wrong = await LoginAsync(gateway, "guess");
            Assert.That(wrong.StatusCode, Is.EqualTo(HttpStatusCode.Unauthorized));
            Assert.That(wrong.Headers.Contains("Set-Cookie"), Is.False);
        }

        using var right = await LoginAsync(gateway, Gateways.OperatorToken);

        Assert.That(right.StatusCode, Is.EqualTo(HttpStatusCode.TooManyRequests));
        Assert.That(gateway.WebSocketConnections[Closure.Token], Is.EqualTo(10));
    }

    [TestCase("localhost", HttpStatusCode.BadRequest)]
    [TestCase("evil.example", HttpStatusCode.Forbidden)]
    public async Task Login_GatewayWithoutTokens_IsRefused(string host, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync();

        using var answer = await PostAsync(gateway, "/operations/login", "{\"token\":\"a\"}", ("Host", host));

        Assert.That(answer.StatusCode, Is.EqualTo(expected));
    }

    [TestCase("GET", "/operations/login")]
    [TestCase("DELETE", "/operations")]
    public async Task Request_OtherMethod_Returns405(string method, string path)
    {
        await using var gateway = await Gateways.StartAsync();
        using var request = new HttpRequestMessage(new HttpMethod(method), UriOf(gateway, path));

        using var answer = await _http.SendAsync(request).Bounded();

        Assert.That(answer.StatusCode, Is.EqualTo(HttpStatusCode.MethodNotAllowed));
    }

    [Test]
    public async Task Page_RequestedWithoutAToken_IsServedWithTheLoginForm()
    {
        Needs.BuiltByNode(Nowpose.Web.Pages.Operations != null);
        await using var gateway = await Gateways.StartAsync(WithTokens);

        using var answer = await _http.GetAsync(UriOf(gateway, "/operations")).Bounded();

        Assert.That(answer.StatusCode, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(gateway.OperationsPageUris, Is.EqualTo(new[] { UriOf(gateway, "/operations") }));
        Assert.That(await answer.Content.ReadAsStringAsync(), Does.Contain("connect-src 'self'"));
    }

    Task<HttpResponseMessage> LoginAsync(GatewayServer gateway, string token) =>
        PostAsync(gateway, "/operations/login", $"{{\"token\":\"{token}\"}}");

    async Task<HttpResponseMessage> PostAsync(GatewayServer gateway, string path, string body, params (string Name, string Value)[] headers)
    {
        using var request = new HttpRequestMessage(HttpMethod.Post, UriOf(gateway, path)) { Content = new StringContent(body) };
        foreach (var (name, value) in headers) request.Headers.TryAddWithoutValidation(name, value);
        return await _http.SendAsync(request).Bounded();
    }

    static Uri UriOf(GatewayServer gateway, string path) => new($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}");

    static string CookieOf(HttpResponseMessage answer) => answer.Headers.GetValues("Set-Cookie").Single().Split(';')[0];

    static Action<ClientWebSocketOptions> Cookie(string value) => options => options.SetRequestHeader("Cookie", value);
}
