using System.Net;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Pairing;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests pairing requests that the gateway refuses, and requests without a valid response.</summary>
public sealed class PairingRequestTests
{
    [Test]
    public void Exchange_UnencryptedToAnotherMachine_IsRefusedWithoutConnection() => Assert.ThrowsAsync<InputException>(
        () => PairingRequest.SendAsync(new ConnectionSettings("10.0.0.7", insecureLan: true), "token", CancellationToken.None));

    [Test]
    public async Task Exchange_PairingDisabled_FailsWithTheNameOfTheOption()
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
        Assert.That(answer.Problem, Does.StartWith(PairingAnswerMessages.Failed("127.0.0.1", "")));
    }

    static readonly string[][] InvalidAnswers =
    [
        ["HTTP/1.1 200 OK\r\nContent-Length: 99999\r\n\r\n", PairingAnswerMessages.TooLong(PairingLimits.BodyBytes)],
        ["HTTP/1.1 200 OK\r\n\r\n", PairingAnswerMessages.TooLong(PairingLimits.BodyBytes)],
        ["HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n", PairingAnswerMessages.TooLong(PairingLimits.BodyBytes)],
        ["HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\nContent-Length: 2\r\n\r\n{}", PairingAnswerMessages.TooLong(PairingLimits.BodyBytes)],
        ["HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\n{}", PairingAnswerMessages.NoToken],
        ["HTTP/1.1 200 OK\r\nContent-Length: 12\r\n\r\n{\"token\":[]}", PairingAnswerMessages.NoToken],
        ["HTTP/1.1 200 OK\r\nContent-Length: 15\r\n\r\n{\"token\":\"a b\"}", PairingAnswerMessages.NoToken],
        ["HTTP/1.1 200 OK\r\nContent-Length: 99\r\n\r\n{}", ConnectionMessages.ClosedBeforeAnswer],
    ];

    [TestCaseSource(nameof(InvalidAnswers))]
    [TestCase("HTTP/1.1 302 Found\r\nLocation: http://10.0.0.7/\r\n\r\n", "status 302")]
    [TestCase("SSH-2.0-OpenSSH\r\n\r\n", ConnectionMessages.NotHttp)]
    [TestCase("\r\n\r\n", ConnectionMessages.NotHttp)]
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
    public async Task Request_Malformed_Returns400(string body)
    {
        await using var gateway = await PairingGateway.StartAsync();

        var (status, text) = await gateway.PostAsync("/pair", body);

        Assert.That(status, Is.EqualTo(HttpStatusCode.BadRequest));
        Assert.That(text.Trim().Split('\n'), Has.Length.EqualTo(1));
    }

    [Test]
    public async Task Request_TooLong_Returns413()
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
}
