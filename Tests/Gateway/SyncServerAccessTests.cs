using System.Net.Security;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway;

/// <summary>Tests tokens and TLS on the sync port.</summary>
public class SyncServerAccessTests
{
    [Test]
    public async Task Token_Valid_IsServed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        await client.SendAsync(SyncToken.Write(Gateways.ObserverToken));

        Assert.That((await client.ReceiveAsync()).Value, Is.EqualTo(SyncFrame.TokenReply(true)));
        Assert.That((await client.ExchangeAsync(SyncFrame.Request(1, 2))).Value.Sequence, Is.EqualTo(1));
    }

    [Test]
    public async Task Token_Wrong_IsRefused()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        await client.SendAsync(SyncToken.Write("guess"));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.False);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
    }

    [Test]
    public async Task Token_WrongAfterAValidOne_IsRefusedAndTheConnectionIsStillServed()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        await client.SendAsync(SyncToken.Write(Gateways.ObserverToken));
        await client.ReceiveAsync();

        await client.SendAsync(SyncToken.Write("guess"));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.False);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
    }

    [Test]
    public async Task Request_TokenMissing_ClosesTheConnection()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
    }

    [Test]
    public async Task Token_NotSentInTime_ClosesTheConnection()
    {
        var options = Gateways.Options() with { Tokens = Gateways.Tokens, TokenTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ReceiveAsync(), Is.Null);
        await Soon.BecomesAsync(() => gateway.SyncConnections[Closure.Token] == 1, "counted");
    }

    [Test]
    public async Task Token_TooLong_ClosesTheConnection()
    {
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        await client.SendAsync(SyncFrame.Token());

        await client.SendAsync([0x01, 0x02]);

        Assert.That(await client.ReceiveAsync(), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.MalformedFrame], Is.EqualTo(1));
    }

    [Test]
    public async Task AnyToken_GatewayWithoutTokens_IsAccepted()
    {
        await using var gateway = await Gateways.StartAsync();
        using var client = await RawSyncClient.ConnectAsync(gateway);

        await client.SendAsync(SyncToken.Write("left over"));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.True);
    }

    [Test]
    public async Task Tls_ClientWithThePinOfTheGateway_IsServed()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate, Tokens = Gateways.Tokens });
        using var client = await RawSyncClient.ConnectAsync(gateway);
        var seen = default(CertificatePin);
        var secure = new SslStream(client.Stream, false, (_, given, _, _) => (seen = CertificatePin.Of(given)) != null);
        await secure.AuthenticateAsClientAsync("localhost").Bounded();
        client.Stream = secure;

        await client.SendAsync(SyncToken.Write(Gateways.SourceToken));

        Assert.That((await client.ReceiveAsync()).Value.IsAccepted, Is.True);
        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Not.Null);
        Assert.That(seen, Is.EqualTo(gateway.Pin));
    }

    [Test]
    public async Task Tls_UnencryptedClient_IsDisconnected()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { Certificate = certificate });
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ExchangeAsync(SyncFrame.Request(1, 2)), Is.Null);
        Assert.That(gateway.SyncConnections[Closure.TlsHandshake], Is.EqualTo(1));
    }

    [Test]
    public async Task Tls_HandshakeMissing_IsCounted()
    {
        using var certificate = CertificateFiles.Generate();
        var options = Gateways.Options() with { Certificate = certificate, TokenTimeout = TimeSpan.FromMilliseconds(200) };
        await using var gateway = await Gateways.StartAsync(options);
        using var client = await RawSyncClient.ConnectAsync(gateway);

        Assert.That(await client.ReceiveAsync(), Is.Null);
        await Soon.BecomesAsync(() => gateway.SyncConnections.Open == 0, "closed");
        Assert.That(gateway.SyncConnections[Closure.TlsHandshake], Is.EqualTo(1));
    }
}
