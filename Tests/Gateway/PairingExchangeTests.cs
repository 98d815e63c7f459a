using System.Net;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Pairing;
using Nowpose.Headless.Tests.Network;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>The headset's side and the gateway's side of the pairing exchange, over sockets of this machine.</summary>
public sealed class PairingExchangeTests
{
    static readonly CertificatePin OtherPin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

    static async Task<HttpStatusCode> RosbridgeStatusAsync(PairingGateway gateway, string token)
    {
        using var link = WebSocketLinks.Create(gateway.CellCode().ToConnection(token, "headset 7"), new StopwatchHeadsetClock());
        try
        {
            await link.OpenAsync(CancellationToken.None).Bounded();
            return HttpStatusCode.SwitchingProtocols;
        }
        catch (GatewayRefusalException refused) when (refused.IsOfToken)
        {
            return HttpStatusCode.Unauthorized;
        }
    }

    [TestCase(true)]
    [TestCase(false)]
    public async Task Exchange_ShownCode_ReturnsAnAcceptedToken(bool isSecure)
    {
        await using var gateway = await PairingGateway.StartAsync(isSecure);
        Assert.That(await RosbridgeStatusAsync(gateway, null), Is.EqualTo(HttpStatusCode.Unauthorized), "the gateway requires a token");

        var answer = await gateway.ExchangeAsync((await gateway.ShownAsync()).Token);

        Assert.That(answer.Problem, Is.Null);
        Assert.That(answer.Token, Does.Match("^[A-Za-z0-9_-]{43}$"), "256 bits");
        Assert.That(await RosbridgeStatusAsync(gateway, answer.Token), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        Assert.That(await RosbridgeStatusAsync(gateway, answer.Token + "a"), Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(gateway.Log, Has.Some.Contains("'headset 7' received a token"));
    }

    [Test]
    public async Task Token_OfAHeadset_OpensTheSyncConnection()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var own = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token)).Token;

        var dialer = new GatewayDialer(gateway.CellCode().ToConnection(own, "a"));
        using var stream = await dialer.OpenAsync(gateway.Server.SyncEndPoint.Port, default).Bounded();
        await stream.WriteAsync(SyncToken.Write(own));
        var reply = new byte[SyncFrame.Size];
        await stream.ReadExactlyAsync(reply).AsTask().Bounded();

        Assert.That(SyncFrame.TryRead(reply, out var frame, out _) && frame.IsAccepted, Is.True);
    }

    [Test]
    public async Task Exchange_SameCodeTwice_WorksOnce()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();

        var answers = await Task.WhenAll(Enumerable.Range(0, 8).Select(_ => gateway.ExchangeAsync(code.Token)));

        Assert.That(answers.Count(answer => answer.Token != null), Is.EqualTo(1));
        Assert.That(answers.Where(answer => answer.Token == null).Select(answer => answer.Problem), Is.All.Contains("was used or is too old"));
        Assert.That(answers.Where(answer => answer.Token == null).Select(answer => answer.IsWorthRetrying), Is.All.False);
        Assert.That((await gateway.ShownAsync()).Token, Is.Not.EqualTo(code.Token), "another one is shown");
    }

    [TestCase(299, true)]
    [TestCase(300, false)]
    public async Task Exchange_AfterSeconds_WorksForFiveMinutes(int seconds, bool works)
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();

        gateway.Time.Advance(TimeSpan.FromSeconds(seconds));

        Assert.That((await gateway.ExchangeAsync(code.Token)).Token != null, Is.EqualTo(works));
        Assert.That(code.ValidToUtc, Is.EqualTo(new DateTime(2026, 11, 20, 12, 5, 0, DateTimeKind.Utc)));
    }

    [Test]
    public async Task Renew_ShownCode_InvalidatesTheFormer()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var former = await gateway.ShownAsync();

        var newer = await gateway.ShownAsync(isRenewed: true);

        Assert.That((await gateway.ShownAsync()).Token, Is.EqualTo(newer.Token), "it stays until it is used");
        Assert.That((await gateway.ExchangeAsync(former.Token)).Token, Is.Null);
        Assert.That((await gateway.ExchangeAsync(newer.Token)).Token, Is.Not.Null);
    }

    [Test]
    public async Task Exchange_NoCodeShown_IsRefused()
    {
        await using var gateway = await PairingGateway.StartAsync();

        Assert.That((await gateway.ExchangeAsync("")).Token, Is.Null);
        Assert.That((await gateway.ExchangeAsync("AAAAAAAAAAAAAAAAAAAAAA")).Token, Is.Null);
    }

    [Test]
    public async Task Exchange_ManyWrongCodes_BlockTheAddressForAMinute()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();
        for (var i = 0; i < PairingLimits.WrongCodesPerMinute; i++)
            Assert.That((await gateway.ExchangeAsync("guess")).IsWorthRetrying, Is.False);

        var blocked = await gateway.ExchangeAsync(code.Token);
        gateway.Time.Advance(TimeSpan.FromMinutes(1));
        var later = await gateway.ExchangeAsync(code.Token);

        Assert.That(blocked.Problem, Does.Contain("too many"));
        Assert.That(blocked.IsWorthRetrying, Is.True);
        Assert.That(later.Token, Is.Not.Null);
    }

    [Test]
    public async Task Exchange_OtherKeyThanPinned_SendsNothing()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();
        var port = gateway.Server.WebSocketEndPoint.Port;

        var answer = await gateway.ExchangeAsync(code.Token, connection: new ConnectionSettings("127.0.0.1", 1, port, OtherPin));

        Assert.That(answer.Problem, Does.Contain("its pin is"));
        Assert.That(answer.IsWorthRetrying, Is.True);
        Assert.That((await gateway.ExchangeAsync(code.Token)).Token, Is.Not.Null, "the code was not used up");
    }

    [Test]
    public void Exchange_PlainToAnotherMachine_IsRefusedWithoutConnection() => Assert.ThrowsAsync<InputException>(
        () => PairingRequest.SendAsync(new ConnectionSettings("10.0.0.7", insecureLan: true), "token", CancellationToken.None));

    [Test]
    public async Task Exchange_PairingDisabled_NamesTheOption()
    {
        await using var gateway = await Gateways.StartAsync();

        var answer = await PairingRequest.SendAsync(
            new ConnectionSettings("127.0.0.1", 1, gateway.WebSocketEndPoint.Port), "token", CancellationToken.None).Bounded();

        Assert.That(answer.Problem, Does.Contain("--pairing"));
        Assert.That(answer.IsWorthRetrying, Is.False);
    }

    [Test]
    public async Task Exchange_ConnectionRefused_CanBeRetried()
    {
        var answer = await PairingRequest.SendAsync(new ConnectionSettings("127.0.0.1", 1, 1), "token", CancellationToken.None).Bounded();

        Assert.That(answer.IsWorthRetrying, Is.True);
        Assert.That(answer.Problem, Does.StartWith("pairing with 127.0.0.1: "));
    }

    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 99999\r\n\r\n", "unknown length or longer")]
    [TestCase("HTTP/1.1 200 OK\r\n\r\n", "unknown length or longer")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n", "unknown length or longer")]
    [TestCase("HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\n{}", "unknown length or longer")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\n{}", "no valid token")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 12\r\n\r\n{\"token\":[]}", "no valid token")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 15\r\n\r\n{\"token\":\"a b\"}", "no valid token")]
    [TestCase("HTTP/1.1 200 OK\r\nContent-Length: 99\r\n\r\n{}", "closed the connection")]
    [TestCase("HTTP/1.1 302 Found\r\nLocation: http://10.0.0.7/\r\n\r\n", "status 302")]
    [TestCase("SSH-2.0-OpenSSH\r\n\r\n", "not HTTP/1.1")]
    [TestCase("\r\n\r\n", "not HTTP/1.1")]
    public async Task Exchange_InvalidAnswer_IsReportedAsAProblem(string text, string part)
    {
        using var server = new FakeWebSocketServer();
        var served = server.AnswerAsync(text);

        var answer = await PairingRequest.SendAsync(new ConnectionSettings("127.0.0.1", 1, server.Port), "token", CancellationToken.None).Bounded();

        await served.Bounded();
        Assert.That(answer.Token, Is.Null);
        Assert.That(answer.Problem, Does.Contain(part));
    }

    [TestCase("")]
    [TestCase("{")]
    [TestCase("[]")]
    [TestCase("{\"token\":\"a\"}")]
    [TestCase("{\"token\":1,\"name\":\"a\"}")]
    [TestCase("{\"token\":\"a\",\"token\":\"a\",\"name\":\"a\"}")]
    [TestCase("{\"token\":{\"a\":{}},\"name\":\"a\"}")]
    public async Task Request_Malformed_Is400(string body)
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (status, text) = await gateway.PostAsync("/pair", body);

        Assert.That(status, Is.EqualTo(HttpStatusCode.BadRequest));
        Assert.That(text.Trim().Split('\n'), Has.Length.EqualTo(1));
    }

    [Test]
    public async Task Request_TooLong_Is413()
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (status, _) = await gateway.PostAsync("/pair", "{\"name\":\"" + new string('a', PairingLimits.BodyBytes) + "\"}");

        Assert.That(status, Is.EqualTo(HttpStatusCode.RequestEntityTooLarge));
    }

    [Test]
    public async Task Request_ForeignPage_Returns403()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();

        var (status, _) = await gateway.PostAsync("/pair", $"{{\"token\":\"{code.Token}\",\"name\":\"a\"}}", ("Origin", "https://evil.example"));

        Assert.That(status, Is.EqualTo(HttpStatusCode.Forbidden));
    }

    [Test]
    public async Task List_Restarted_HasOnlyHashesAndStillAcceptsTheToken()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var own = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "Anna's\n \u0007headset")).Token;

        await gateway.RestartAsync();

        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        var list = File.ReadAllText(gateway.ListPath);
        Assert.That(list, Does.Not.Contain(own));
        Assert.That(list.Split('\n')[1], Does.Match("^observer sha256/[A-Za-z0-9+/]{43}= 2026-11-20T12:00:00Z Anna's headset$"));
        if (!OperatingSystem.IsWindows())
            Assert.That(File.GetUnixFileMode(gateway.ListPath), Is.EqualTo(UnixFileMode.UserRead | UnixFileMode.UserWrite));
    }

    [Test]
    public async Task List_LineRemoved_RevokesTheToken()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var first = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "first")).Token;
        var second = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "second")).Token;

        File.WriteAllLines(gateway.ListPath, File.ReadAllLines(gateway.ListPath).Where(line => !line.EndsWith(" first", StringComparison.Ordinal)));

        Assert.That(await RosbridgeStatusAsync(gateway, first), Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(await RosbridgeStatusAsync(gateway, second), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
    }

    [Test]
    public async Task Pairings_Revoke_RemovesTheHeadsetsOfThatName()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var first = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "Anna's headset")).Token;
        var second = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token, "second")).Token;

        var status = await Nowpose.Gateway.CommandLine.RunAsync(["pairings", "--pairing", gateway.ListPath, "--revoke", "Anna's headset"]).Bounded();

        Assert.That(status, Is.EqualTo(0));
        Assert.That(await RosbridgeStatusAsync(gateway, first), Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(await RosbridgeStatusAsync(gateway, second), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
    }

    [Test]
    public async Task List_DamagedWhileRunning_IsLoggedOnceAndTheFormerStaysInUse()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var own = (await gateway.ExchangeAsync((await gateway.ShownAsync()).Token)).Token;

        File.AppendAllText(gateway.ListPath, "something else\n");

        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        Assert.That(await RosbridgeStatusAsync(gateway, own), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        Assert.That(gateway.Log.Count(line => line.Contains("line 3: not an entry of a paired headset")), Is.EqualTo(1));
    }

    [Test]
    public async Task List_CannotBeWritten_Is503AndTheCodeStaysValid()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();
        File.Delete(gateway.ListPath);
        Directory.CreateDirectory(gateway.ListPath);

        var failed = await gateway.ExchangeAsync(code.Token);
        Directory.Delete(gateway.ListPath);
        var worked = await gateway.ExchangeAsync(code.Token);

        Assert.That(failed.Problem, Does.Contain("cannot save"));
        Assert.That(failed.IsWorthRetrying, Is.True);
        Assert.That(worked.Token, Is.Not.Null);
    }

    [Test]
    public async Task Log_AnyExchange_ContainsNoTokenOrCode()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();
        var own = await gateway.ExchangeAsync(code.Token);
        await gateway.ExchangeAsync("wrong-code");

        Assert.That(string.Join('\n', gateway.Log), Does.Not.Contain(code.Token).And.Not.Contain(own.Token).And.Not.Contain("wrong-code"));
    }
}
