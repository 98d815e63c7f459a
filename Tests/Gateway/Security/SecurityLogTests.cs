using System.Net;
using System.Net.Http.Headers;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Gateway.Status.Events;
using Nowpose.Headless.Tests.Gateway.Status.Faults;
using Nowpose.Pairing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Tests of the log lines that show who did what, and that clients cannot suppress them.</summary>
public sealed class SecurityLogTests
{
    static readonly string OperatorId = Id(Gateways.OperatorToken);

    readonly HttpClient _http = new(new SocketsHttpHandler { UseCookies = false });
    MonitoredGateway _gateway;
    string _folder;

    [SetUp]
    public async Task SetUpAsync()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-log-").FullName;
        _gateway = new MonitoredGateway();
        await _gateway.StartAsync(options => options with { Tokens = Gateways.Tokens, Recordings = _folder });
    }

    [TearDown]
    public async Task TearDownAsync()
    {
        await _gateway.DisposeAsync();
        Directory.Delete(_folder, true);
    }

    [OneTimeTearDown]
    public void OneTimeTearDown() => _http.Dispose();

    [Test]
    public async Task Log_ManyEventsOfNewHeadsets_ContainsOtherEventsAndRefusals()
    {
        for (var i = 0; i < 1000; i++) _gateway.Server.Events.Note(new Condition("headset", $"headset-{i}", "is lost", "", Level.Warning));

        _gateway.Server.Events.Note(new Condition("joint", "a", "is refused", "", Level.Error));
        await GetAsync("/operations/state", "unknown");

        Assert.That(_gateway.Log, Has.One.Contains("joint a is refused"));
        Assert.That(_gateway.Log, Has.One.StartsWith(AccessMessages.Refused(Closure.Token)));
    }

    [Test]
    public async Task Log_RefusedToken_NamesOnlyTheAddress()
    {
        await GetAsync("/operations/state", "unknown");

        Assert.That(_gateway.Log, Has.One.EqualTo($"{AccessMessages.Refused(Closure.Token)} from 127.0.0.1"));
        Assert.That(_gateway.Log, Has.None.Contains("unknown").And.None.Contains(Id("unknown")));
    }

    [Test]
    public async Task Log_Login_NamesTheAddressAndTheToken()
    {
        await PostAsync("/operations/login", $"{{\"token\":\"{Gateways.OperatorToken}\"}}");
        await PostAsync("/operations/login", "{\"token\":\"unknown\"}");

        Assert.That(_gateway.Log, Has.One.EqualTo($"{OperationsMessages.LoggedIn} from 127.0.0.1 (operator, token {OperatorId})"));
        Assert.That(_gateway.Log, Has.One.EqualTo($"{OperationsMessages.UnknownTokenLog} from 127.0.0.1"));
    }

    [Test]
    public async Task Log_Recorder_NamesWhoSwitchedItAndWhoDownloaded()
    {
        await PostAsync("/operations/recording", "{\"on\":\"true\"}", Gateways.ObserverToken);
        await PostAsync("/operations/recording", "{\"on\":\"true\"}", Gateways.OperatorToken);
        await PostAsync("/operations/recording", "{\"on\":\"false\"}", Gateways.OperatorToken);
        var name = Path.GetFileName(Directory.GetFiles(_folder).Single());
        await GetAsync($"/operations/recordings/{name}", Gateways.OperatorToken);

        var by = $"from 127.0.0.1 (operator, token {OperatorId})";
        Assert.That(_gateway.Log, Has.One.StartsWith(AccessMessages.OperatorOnlyLog + " from 127.0.0.1 (observer, token "));
        Assert.That(_gateway.Log, Has.One.EqualTo($"{RecorderMessages.Enabled} {by}"));
        Assert.That(_gateway.Log, Has.One.EqualTo($"{RecorderMessages.Disabled} {by}"));
        Assert.That(_gateway.Log, Has.One.EqualTo($"{RecorderMessages.Download}{name} {by}"));
    }

    [Test]
    public async Task Log_RefusedForNow_NamesTheAddressAndTheReason()
    {
        await using var gateway = new MonitoredGateway();
        await gateway.StartAsync(options => options with { MaxConnections = 1, SyncRequestsPerSecond = 1 });
        using (await RawRosbridgeClient.ConnectAsync(gateway.Server))
        {
            foreach (var line in new[] { $"GET / HTTP/1.1\r\n{RawWebSocket.Upgrade}", "POST /vlc/time HTTP/1.1\r\nContent-Length: 0\r\n" })
            {
                using var refused = await RawWebSocket.ConnectAsync(gateway.Server);
                await refused.SendAsync(Encoding.ASCII.GetBytes($"{line}Host: localhost\r\n\r\n"));
                Assert.That(await refused.ReadToEndAsync(), Does.StartWith("HTTP/1.1 503 "));
            }
        }

        Assert.That(gateway.Log, Has.Exactly(2).StartsWith(AccessMessages.Refused(Closure.ConnectionLimit) + " from 127.0.0.1 (source"));
    }

    [Test]
    public async Task Log_LoginFromABlockedAddress_NamesTheAddress()
    {
        for (var i = 0; i <= PairingLimits.WrongCodesPerMinute; i++) await PostAsync("/operations/login", "{\"token\":\"unknown\"}");

        Assert.That(_gateway.Log, Has.One.EqualTo($"{AccessMessages.BlockedLog} from 127.0.0.1"));
    }

    // The first 8 digits of its hash would show that a guess of a weak token is right.
    [TestCase("press-3", false)]
    [TestCase("f3a19c0d5b7e42681d9f0a3c5e7b9d1f2a4c6e80", true)]
    public async Task Log_RefusedRequest_HasAPartOfTheHashOnlyOfAStrongToken(string token, bool isLogged)
    {
        var path = Path.Combine(_folder, "tokens.txt");
        await File.WriteAllTextAsync(path, $"observer {token}\n");
        await using var gateway = new MonitoredGateway();
        await gateway.StartAsync(options => options with { Tokens = TokenList.Read(path), Recordings = _folder });
        using var request = new HttpRequestMessage(HttpMethod.Post, $"http://127.0.0.1:{gateway.Server.WebSocketEndPoint.Port}/operations/recording");
        request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        request.Content = new StringContent("{\"on\":\"true\"}", Encoding.UTF8, "application/json");

        using var response = await _http.SendAsync(request).Bounded();

        var by = isLogged ? $"(observer, token {Id(token)})" : "(observer)";
        Assert.That(gateway.Log, Has.One.EqualTo($"{AccessMessages.OperatorOnlyLog} from 127.0.0.1 {by}"));
    }

    static string Id(string token) => Convert.ToHexStringLower(TokenList.HashOf(token))[..8];

    async Task GetAsync(string path, string token)
    {
        using var request = new HttpRequestMessage(HttpMethod.Get, UriOf(path));
        request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        using var response = await _http.SendAsync(request).Bounded();
        await response.Content.ReadAsStringAsync().Bounded();
    }

    async Task PostAsync(string path, string json, string token = null)
    {
        using var request = new HttpRequestMessage(HttpMethod.Post, UriOf(path)) { Content = new StringContent(json, Encoding.UTF8, "application/json") };
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        using var response = await _http.SendAsync(request).Bounded();
        await response.Content.ReadAsStringAsync().Bounded();
    }

    Uri UriOf(string path) => new($"http://127.0.0.1:{_gateway.Server.WebSocketEndPoint.Port}{path}");
}
