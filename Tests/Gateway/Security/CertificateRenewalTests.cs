using System.Collections.Concurrent;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Messages;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class CertificateRenewalTests
{
    readonly ConcurrentQueue<string> _log = [];
    string _folder;

    string CertificatePath => Path.Combine(_folder, "gateway.pem");

    [SetUp]
    public void SetUp()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-renewal").FullName;
        _log.Clear();
    }

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [Test]
    public async Task File_RenewedWithTheSameKey_IsUsedWithoutARestart()
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        CertificatesOfOneKey.Write(CertificatePath, key, days: 10);
        var options = Gateways.Options() with { CertificateFile = Follow() };
        await using var gateway = await Gateways.StartAsync(options);
        var former = await ShownAsync(gateway);

        CertificatesOfOneKey.Write(CertificatePath, key, days: 400);

        await Soon.BecomesAsync(() => ShownAsync(gateway).Result.NotAfter > former.NotAfter, "shown");
        Assert.That(CertificatePin.Of(await ShownAsync(gateway)), Is.EqualTo(gateway.Pin));
        Assert.That(options.CertificateExpires, Is.GreaterThan(DateTime.UtcNow.AddDays(399)));
        Assert.That(_log, Is.EqualTo(new[] { KeyFileMessages.Renewed(options.CertificateExpires.Value) }));
    }

    [Test]
    public async Task File_RenewedWithAnotherKey_IsIgnoredAndLogged()
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        using var other = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        CertificatesOfOneKey.Write(CertificatePath, key, days: 400);
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { CertificateFile = Follow() });

        CertificatesOfOneKey.Write(CertificatePath, other, days: 400);

        var expected = KeyFileMessages.OtherKey(CertificatePath, null).Split("(pin")[0];
        await Soon.BecomesAsync(() => _log.Any(line => line.StartsWith(expected, StringComparison.Ordinal)), "logged");
        Assert.That(CertificatePin.Of(await ShownAsync(gateway)), Is.EqualTo(gateway.Pin));
    }

    CertificateFile Follow() => new(CertificatePath, null, _log.Enqueue);

    static async Task<X509Certificate2> ShownAsync(Nowpose.Gateway.GatewayServer gateway)
    {
        using var client = await RawSyncClient.ConnectAsync(gateway);
        var shown = default(X509Certificate2);
        await using var secure = new System.Net.Security.SslStream(client.Stream, false, (_, given, _, _) => (shown = new X509Certificate2(given)) != null);
        await secure.AuthenticateAsClientAsync("localhost").Bounded();
        return shown;
    }
}
