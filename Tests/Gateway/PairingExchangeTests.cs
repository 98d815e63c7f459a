using System.Net;
using Nowpose.Gateway.Messages;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Pairing;
using Nowpose.Protocol;
using NUnit.Framework;
using static Nowpose.Headless.Tests.Gateway.RosbridgeAnswer;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests the exchange of a pairing code for a token between headset and gateway, over sockets on this machine.</summary>
public sealed class PairingExchangeTests
{
    static readonly CertificatePin OtherPin = CertificatePin.Parse(Convert.ToBase64String(new byte[32]));

    [TestCase(true)]
    [TestCase(false)]
    public async Task Exchange_DisplayedCode_ReturnsAValidToken(bool isSecure)
    {
        await using var gateway = await PairingGateway.StartAsync(isSecure);
        Assert.That(await RosbridgeStatusAsync(gateway, null), Is.EqualTo(HttpStatusCode.Unauthorized), "the gateway requires a token");

        var answer = await gateway.ExchangeAsync((await gateway.ShownAsync()).Token);

        Assert.That(answer.Problem, Is.Null);
        Assert.That(answer.Token, Does.Match("^[A-Za-z0-9_-]{43}$"), "256 bits");
        Assert.That(await RosbridgeStatusAsync(gateway, answer.Token), Is.EqualTo(HttpStatusCode.SwitchingProtocols));
        Assert.That(await RosbridgeStatusAsync(gateway, answer.Token + "a"), Is.EqualTo(HttpStatusCode.Unauthorized));
        Assert.That(gateway.Log, Has.Some.StartsWith(PairingServiceMessages.TokenGiven + PairingServiceMessages.To("headset 7") + " from 127.0.0.1 (observer, token "));
    }

    [Test]
    public async Task Token_OfAPairedHeadset_OpensTheSyncConnection()
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
    public async Task Exchange_SameCodeTwice_SucceedsOnlyOnce()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();

        var answers = await Task.WhenAll(Enumerable.Range(0, 8).Select(_ => gateway.ExchangeAsync(code.Token)));

        Assert.That(answers.Count(answer => answer.Token != null), Is.EqualTo(1));
        Assert.That(answers.Where(answer => answer.Token == null).Select(answer => answer.Problem),
            Is.All.EqualTo(PairingAnswerMessages.NotAccepted));
        Assert.That(answers.Where(answer => answer.Token == null).Select(answer => answer.IsWorthRetrying), Is.All.False);
        Assert.That((await gateway.ShownAsync()).Token, Is.Not.EqualTo(code.Token), "another code is shown");
    }

    [TestCase(299, true)]
    [TestCase(300, false)]
    public async Task Exchange_CodeOfAnyAge_SucceedsOnlyWithinFiveMinutes(int seconds, bool works)
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();

        gateway.Time.Advance(TimeSpan.FromSeconds(seconds));

        Assert.That((await gateway.ExchangeAsync(code.Token)).Token != null, Is.EqualTo(works));
        Assert.That(code.ValidToUtc, Is.EqualTo(new DateTime(2026, 11, 20, 12, 5, 0, DateTimeKind.Utc)));
    }

    [Test]
    public async Task Renew_CodeDisplayed_InvalidatesThePreviousCode()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var former = await gateway.ShownAsync();

        var newer = await gateway.ShownAsync(isRenewed: true);

        Assert.That((await gateway.ShownAsync()).Token, Is.EqualTo(newer.Token), "the code is shown until it is used");
        Assert.That((await gateway.ExchangeAsync(former.Token)).Token, Is.Null);
        Assert.That((await gateway.ExchangeAsync(newer.Token)).Token, Is.Not.Null);
    }

    [Test]
    public async Task Exchange_NoCodeDisplayed_IsRefused()
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

        Assert.That(blocked.Problem, Is.EqualTo(PairingAnswerMessages.TooManyWrong));
        Assert.That(blocked.IsWorthRetrying, Is.True);
        Assert.That(later.Token, Is.Not.Null);
    }

    [Test]
    public async Task Exchange_GatewayKeyDiffersFromThePin_SendsNothing()
    {
        await using var gateway = await PairingGateway.StartAsync();
        var code = await gateway.ShownAsync();
        var port = gateway.Server.WebSocketEndPoint.Port;

        var answer = await gateway.ExchangeAsync(code.Token, connection: new ConnectionSettings("127.0.0.1", 1, port, OtherPin));

        Assert.That(answer.Problem, Does.EndWith(CertificateMessages.OtherPin(gateway.Server.Pin, OtherPin)));
        Assert.That(answer.IsWorthRetrying, Is.True);
        Assert.That((await gateway.ExchangeAsync(code.Token)).Token, Is.Not.Null, "the code is still valid");
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
