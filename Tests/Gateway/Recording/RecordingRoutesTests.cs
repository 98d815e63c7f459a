using System.Net;
using System.Net.Http.Headers;
using System.Text;
using System.Text.Json;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway.Recording;

public class RecordingRoutesTests
{
    const string Operator = "operator-token";

    static readonly TokenList Tokens = new([(Gateways.ObserverToken, Role.Observer), (Gateways.SourceToken, Role.Source), (Operator, Role.Operator)]);

    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-recordings-").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    static async Task<(HttpStatusCode Status, string Text)> SwitchAsync(GatewayServer gateway, string on, string token = null, string origin = null)
    {
        using var http = new HttpClient();
        using var request = new HttpRequestMessage(HttpMethod.Post, new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/operations/recording"))
        {
            Content = new StringContent($"{{\"on\":\"{on}\"}}", Encoding.UTF8, "application/json"),
        };
        if (token != null) request.Headers.Authorization = new AuthenticationHeaderValue("Bearer", token);
        if (origin != null) request.Headers.Add("Origin", origin);
        using var response = await http.SendAsync(request).Bounded();
        return (response.StatusCode, await response.Content.ReadAsStringAsync().Bounded());
    }

    [Test]
    public async Task Switch_OnAndOff_WritesTheFileThatTheStateNames()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Recordings = _folder });

        var (on, text) = await SwitchAsync(gateway, "true");
        Assert.That(on, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(JsonDocument.Parse(text).RootElement.GetProperty("on").GetBoolean(), Is.True);
        using var http = new HttpClient();
        var state = await http.GetStringAsync(new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}/operations/state")).Bounded();
        var recording = JsonDocument.Parse(state).RootElement.GetProperty("recording");
        Assert.That(recording.GetProperty("can").GetBoolean(), Is.True);
        Assert.That(recording.GetProperty("file").GetString(), Does.EndWith(".jsonl").And.Not.Contain("/"));

        var (off, _) = await SwitchAsync(gateway, "false");
        Assert.That(off, Is.EqualTo(HttpStatusCode.OK));
        Assert.That(File.ReadAllLines(Directory.GetFiles(_folder).Single())[^1], Does.Contain("\"end\""));
    }

    [TestCase(null, HttpStatusCode.Unauthorized)]
    [TestCase(Gateways.ObserverToken, HttpStatusCode.Forbidden)]
    [TestCase(Gateways.SourceToken, HttpStatusCode.Forbidden)]
    [TestCase(Operator, HttpStatusCode.OK)]
    public async Task Switch_GatewayWithTokens_RequiresAnOperator(string token, HttpStatusCode expected)
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Recordings = _folder, Tokens = Tokens });

        Assert.That((await SwitchAsync(gateway, "true", token)).Status, Is.EqualTo(expected));
        Assert.That(gateway.Recorder.IsOn, Is.EqualTo(expected == HttpStatusCode.OK));
    }

    [Test]
    public async Task Switch_FromAForeignPage_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Recordings = _folder });

        Assert.That((await SwitchAsync(gateway, "true", origin: "http://evil.example")).Status, Is.EqualTo(HttpStatusCode.Forbidden));
        Assert.That(gateway.Recorder.IsOn, Is.False);
    }

    [Test]
    public async Task Switch_NoFolder_FailsWithTheNameOfTheOption()
    {
        await using var gateway = await Gateways.StartAsync();

        var (status, text) = await SwitchAsync(gateway, "true");

        Assert.That(status, Is.EqualTo(HttpStatusCode.Conflict));
        Assert.That(text, Does.Contain("--recordings"));
    }

    [Test]
    public async Task Switch_NeitherOnNorOff_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Recordings = _folder });

        Assert.That((await SwitchAsync(gateway, "maybe")).Status, Is.EqualTo(HttpStatusCode.BadRequest));
    }
}
