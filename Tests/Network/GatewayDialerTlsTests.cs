using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Security.Authentication;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Security;
using Nowpose.Messages;
using Nowpose.Network;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public sealed class GatewayDialerTlsTests
{
    X509Certificate2 _certificate;
    TcpListener _listener;
    GatewayDialer _dialer;

    [SetUp]
    public void Listen()
    {
        _certificate = CertificateFiles.Generate();
        _listener = new TcpListener(IPAddress.Loopback, 0);
        _listener.Start();
        _dialer = new GatewayDialer(new ConnectionSettings("127.0.0.1", pin: CertificatePin.Of(_certificate)));
    }

    [TearDown]
    public void Stop()
    {
        _listener.Stop();
        _certificate.Dispose();
    }

    /// <summary>Unity's TLS needs an explicit version, and 1.2 is the only one that it supports in all versions of Unity.</summary>
    [TestCase(SslProtocols.Tls12)]
    [TestCase(SslProtocols.Tls12 | SslProtocols.Tls13)]
    public async Task Open_ServerSupportsTls12_UsesThisVersion(SslProtocols supported)
    {
        var opening = _dialer.OpenAsync(Port, default);
        using var client = await _listener.AcceptTcpClientAsync().Bounded();
        await using var secure = new SslStream(client.GetStream());

        await secure.AuthenticateAsServerAsync(_certificate, false, supported, false).Bounded();
        await using var opened = await opening.Bounded();

        Assert.That(secure.SslProtocol, Is.EqualTo(SslProtocols.Tls12));
    }

    [Test]
    public async Task Open_ServerRefusesTheVersion_ThrowsWithTheReason()
    {
        var opening = _dialer.OpenAsync(Port, default);
        using var client = await _listener.AcceptTcpClientAsync().Bounded();
        await using var secure = new SslStream(client.GetStream());

        Assert.That(async () => await secure.AuthenticateAsServerAsync(_certificate, false, SslProtocols.Tls13, false).Bounded(), Throws.Exception);

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => opening.Bounded());
        Assert.That(failure.Message, Is.EqualTo(ConnectionMessages.TlsFailed(failure.InnerException.GetBaseException().Message)));
        Assert.That(failure.Message, Does.Not.Contain("inner exception"), "the message is the reason itself");
        Assert.That(failure.Message, Does.Contain("TLS 1.2"), "the version that the headset uses");
    }

    [Test]
    public async Task Open_ServerWithoutTls_ThrowsThatTlsFailed()
    {
        var opening = _dialer.OpenAsync(Port, default);
        using var client = await _listener.AcceptTcpClientAsync().Bounded();

        await client.GetStream().WriteAsync(new byte[64]);

        var failure = Assert.ThrowsAsync<GatewayRefusalException>(() => opening.Bounded());
        Assert.That(failure.Message, Is.EqualTo(ConnectionMessages.TlsFailed(failure.InnerException.GetBaseException().Message)));
    }

    int Port => ((IPEndPoint)_listener.LocalEndpoint).Port;
}
