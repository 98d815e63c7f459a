using System.Collections.Concurrent;
using System.Net;
using System.Text;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Pairing;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Sends a recognisable token in each place that accepts a token, and checks that it appears in no output.</summary>
public class SecretTests
{
    const string Secret = "s3cr3t-needle";

    readonly ConcurrentQueue<string> _log = [];
    string _folder;

    string TokensPath => Path.Combine(_folder, "tokens.txt");
    string PairingPath => Path.Combine(_folder, "paired.txt");

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-secrets").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [Test]
    public async Task Secrets_SentInAllPlaces_AppearInNoLogAnswerOrFile()
    {
        File.WriteAllText(TokensPath, $"source {Secret}-right\nobserver {Secret}-other\noperator {Secret}-operator\n");
        var headsets = new HeadsetList(PairingPath, log: _log.Enqueue);
        var token = headsets.Add("seven", out _);
        var answers = new StringBuilder();
        var options = Gateways.Options() with { Tokens = TokenList.Read(TokensPath, _log.Enqueue), Headsets = headsets };
        await using (var gateway = await GatewayServer.StartAsync(options, new StopwatchControlClock(Gateways.Start), _log.Enqueue))
        {
            await UpgradesAsync(gateway, answers);
            await PostsAsync(gateway, answers);
            await SyncsAsync(gateway);
            using var client = await RawRosbridgeClient.ConnectAsync(gateway, Bearer($"{Secret}-right"));
            answers.AppendLine((await client.RoundTripAsync()).ToString());
            answers.AppendLine(await GetAsync(gateway, "/operations/state", $"{Secret}-operator"));
            answers.AppendLine(await GetAsync(gateway, "/metrics", $"{Secret}-operator"));
            // The gateway also reports a damaged line and a revoked token.
            File.WriteAllText(TokensPath, $"source {Secret}-right\nadmin {Secret}-damaged\n");
            await Soon.BecomesAsync(() => _log.Any(line => line.Contains("line 2")), "the damaged line is logged");
            File.WriteAllText(TokensPath, $"observer {Secret}-other\n");
            await Soon.BecomesAsync(() => gateway.WebSocketConnections[Closure.Token] > 4, "revoked");
        }

        Assert.That(_log, Is.Not.Empty);
        Assert.That(string.Join('\n', _log), Does.Not.Contain(Secret).And.Not.Contain(token));
        Assert.That(answers.ToString(), Does.Contain("nowpose").And.Not.Contain(Secret).And.Not.Contain(token));
        Assert.That(File.ReadAllText(PairingPath), Does.Contain("sha256/").And.Not.Contain(token).And.Not.Contain(Secret));
    }

    static async Task UpgradesAsync(GatewayServer gateway, StringBuilder answers)
    {
        foreach (var header in new[] { $"Bearer {Secret}-wrong", $"Basic {Secret}", $"{Secret}", $"Bearer {Secret} {Secret}" })
        {
            using var client = await RawWebSocket.ConnectAsync(gateway);
            answers.Append(await client.RequestAsync($"Authorization: {header}\r\n"));
        }

        using var lost = await RawWebSocket.ConnectAsync(gateway);
        answers.Append(await lost.RequestAsync($"Cookie: nowpose-{gateway.WebSocketEndPoint.Port}={Secret}\r\n"));
    }

    static async Task PostsAsync(GatewayServer gateway, StringBuilder answers)
    {
        using var http = new HttpClient();
        foreach (var path in new[] { "/operations/login", "/pair" })
        {
            foreach (var body in new[] { $"{{\"token\":\"{Secret}-wrong\",\"name\":\"x\"}}", $"{{\"token\":\"{Secret}", Secret })
            {
                using var content = new StringContent(body);
                using var response = await http.PostAsync(new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}"), content).Bounded();
                answers.AppendLine(response.Headers.ToString()).AppendLine(await response.Content.ReadAsStringAsync());
            }
        }
    }

    static async Task SyncsAsync(GatewayServer gateway)
    {
        using var client = await RawSyncClient.ConnectAsync(gateway);
        await client.SendAsync(SyncToken.Write($"{Secret}-wrong"));
        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.False);
        await client.SendAsync(Encoding.ASCII.GetBytes(Secret.PadRight(SyncFrame.Size)));
        Assert.That(await client.ReceiveAsync(), Is.Null);
    }

    static async Task<string> GetAsync(GatewayServer gateway, string path, string token)
    {
        using var http = new HttpClient();
        http.DefaultRequestHeaders.Add("Authorization", "Bearer " + token);
        using var response = await http.GetAsync(new Uri($"http://127.0.0.1:{gateway.WebSocketEndPoint.Port}{path}")).Bounded();
        Assert.That(response.StatusCode, Is.EqualTo(HttpStatusCode.OK), path);
        return await response.Content.ReadAsStringAsync();
    }

    static Action<System.Net.WebSockets.ClientWebSocketOptions> Bearer(string token) =>
        options => options.SetRequestHeader("Authorization", "Bearer " + token);
}
