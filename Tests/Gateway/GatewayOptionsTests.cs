using System.Net;
using NUnit.Framework;
using Nowpose.Gateway;
using Nowpose.Gateway.Clock;
using Nowpose.Gateway.Security;

namespace Nowpose.Headless.Tests.Gateway;

public class GatewayOptionsTests
{
    static readonly GatewayOptions Lan = Gateways.Options() with { Bind = IPAddress.Any };

    static void Refuse(GatewayOptions options, string part) => Refuse<InputException>(options, part);

    static void Refuse<TError>(GatewayOptions options, string part) where TError : Exception
    {
        var error = Assert.CatchAsync<TError>(() => GatewayServer.StartAsync(options, new StopwatchControlClock(Gateways.Start)));

        Assert.That(error.Message, Does.Contain(part));
        Assert.That(error.Message, Does.Not.Contain("\n"));
    }

    [Test]
    public void Start_UnencryptedOnTheLan_RequiresInsecureLan() => Refuse(Lan, "--insecure-lan");

    [TestCase(false)]
    [TestCase(true)]
    public void Start_TokensWithoutTlsOnTheLan_IsRefused(bool insecure) =>
        Refuse(Lan with { Tokens = Gateways.Tokens, AllowInsecureLan = insecure }, "--tls");

    [Test]
    public async Task Start_TokensOverTlsOnTheLan_Runs()
    {
        using var certificate = CertificateFiles.Generate();
        await using var gateway = await Gateways.StartAsync(Lan with { Tokens = Gateways.Tokens, Certificate = certificate });

        Assert.That(gateway.Pin, Is.Not.Null);
    }

    [Test]
    public async Task Start_UnencryptedOnTheLanWithInsecureLan_Runs()
    {
        await using var gateway = await Gateways.StartAsync(Lan with { AllowInsecureLan = true });

        Assert.That(gateway.Pin, Is.Null);
    }

    [Test]
    public async Task Start_PortInUse_ThrowsWithTheOption()
    {
        await using var gateway = await Gateways.StartAsync();

        // The exception is not an InputException, because the port may be free at the next start.
        Refuse<IOException>(Gateways.Options() with { SyncPort = gateway.SyncEndPoint.Port }, $"--sync-port {gateway.SyncEndPoint.Port}");
        Refuse<IOException>(
            Gateways.Options() with { WebSocketPort = gateway.WebSocketEndPoint.Port }, $"--ws-port {gateway.WebSocketEndPoint.Port}");
    }

    [Test]
    public async Task Start_PortInUseOnAllAddresses_IsRefusedOnOneAddress()
    {
        await using var gateway = await Gateways.StartAsync(Lan with { AllowInsecureLan = true });

        Refuse<IOException>(Gateways.Options() with { SyncPort = gateway.SyncEndPoint.Port }, $"--sync-port {gateway.SyncEndPoint.Port}");
        Refuse<IOException>(
            Gateways.Options() with { WebSocketPort = gateway.WebSocketEndPoint.Port }, $"--ws-port {gateway.WebSocketEndPoint.Port}");
    }
}
