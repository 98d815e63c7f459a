using System.Net;
using System.Net.Security;
using System.Net.Sockets;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway;
using Nowpose.Gateway.Security;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Gateway.Security;

public class CertificateChainTests
{
    string _folder;
    X509Certificate2 _root, _intermediate, _leaf;
    ECDsa _key;
    TcpListener _issuerServer;

    [SetUp]
    public void SetUp()
    {
        _folder = Directory.CreateTempSubdirectory("nowpose-chain").FullName;
        _issuerServer = new TcpListener(IPAddress.Loopback, 0);
        _issuerServer.Start();
        _root = Authority("CN=root", issuer: null);
        _intermediate = Authority("CN=intermediate", _root);
        _key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        _leaf = Leaf();
    }

    [TearDown]
    public void TearDown()
    {
        foreach (var one in new IDisposable[] { _root, _intermediate, _leaf, _key, _issuerServer }) one.Dispose();
        Directory.Delete(_folder, true);
    }

    [TestCase("gateway.pem", false)]
    [TestCase("gateway.pem", true)]
    [TestCase("gateway.pfx", false)]
    public async Task Connect_IssuerInTheFile_IsSentOnBothPortsWithoutADownload(string name, bool hasKeyFile)
    {
        var file = Write(name, hasKeyFile, _leaf, _intermediate);
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { CertificateFile = file });

        foreach (var port in new[] { gateway.SyncEndPoint, gateway.WebSocketEndPoint })
            Assert.That(await ReceivedAsync(port), Is.EqualTo(new[] { "CN=gateway", "CN=intermediate", "CN=root" }), port.ToString());
        Assert.That(_issuerServer.Pending(), Is.False, "issuer downloaded");
    }

    [Test]
    public async Task Connect_IssuerUnknown_ConnectsWithoutADownload()
    {
        var file = Write("gateway.pem", hasKeyFile: false, _leaf);
        await using var gateway = await Gateways.StartAsync(Gateways.Options() with { CertificateFile = file });

        foreach (var port in new[] { gateway.SyncEndPoint, gateway.WebSocketEndPoint })
            Assert.That(await ReceivedAsync(port), Is.EqualTo(new[] { "CN=gateway" }), port.ToString());
        Assert.That(_issuerServer.Pending(), Is.False, "issuer downloaded");
    }

    // The chain that a client builds, which knows the root and the certificates that the server sends, but no other ones.
    async Task<string[]> ReceivedAsync(IPEndPoint port)
    {
        var names = Array.Empty<string>();
        using var client = new TcpClient();
        await client.ConnectAsync(port).Bounded();
        await using var secure = new SslStream(client.GetStream());
        await secure.AuthenticateAsClientAsync(new SslClientAuthenticationOptions
        {
            TargetHost = "localhost",
            CertificateChainPolicy = new X509ChainPolicy
            {
                TrustMode = X509ChainTrustMode.CustomRootTrust, CustomTrustStore = { _root }, RevocationMode = X509RevocationMode.NoCheck,
                DisableCertificateDownloads = true,
            },
            RemoteCertificateValidationCallback = (_, _, chain, _) =>
            {
                names = [.. chain.ChainElements.Select(element => element.Certificate.Subject)];
                return true;
            },
        }).Bounded();
        return names;
    }

    CertificateFile Write(string name, bool hasKeyFile, params X509Certificate2[] certificates)
    {
        var path = Path.Combine(_folder, name);
        var key = _key.ExportPkcs8PrivateKeyPem();
        var keyPath = hasKeyFile ? Path.Combine(_folder, "key.pem") : null;
        if (hasKeyFile) File.WriteAllText(keyPath, key);
        if (name.EndsWith(".pfx", StringComparison.Ordinal))
        {
            using var withKey = certificates[0].CopyWithPrivateKey(_key);
            var all = new X509Certificate2Collection((X509Certificate2[])[withKey, .. certificates[1..]]);
            File.WriteAllBytes(path, all.Export(X509ContentType.Pfx));
        }
        else File.WriteAllText(path, string.Join("\n", certificates.Select(one => one.ExportCertificatePem())) + (hasKeyFile ? "" : "\n" + key));

        return new CertificateFile(path, keyPath, log: null);
    }

    static X509Certificate2 Authority(string name, X509Certificate2 issuer)
    {
        var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        var request = new CertificateRequest(name, key, HashAlgorithmName.SHA256);
        request.CertificateExtensions.Add(new X509BasicConstraintsExtension(true, false, 0, true));
        request.CertificateExtensions.Add(new X509SubjectKeyIdentifierExtension(request.PublicKey, false));
        var (from, to) = (DateTimeOffset.UtcNow.AddDays(-2), DateTimeOffset.UtcNow.AddDays(30));
        if (issuer == null) return request.CreateSelfSigned(from, to);
        using var signed = request.Create(issuer, from, to, [1, 2, 3]);
        return signed.CopyWithPrivateKey(key);
    }

    // A certificate with the address from which its issuer could be downloaded.
    X509Certificate2 Leaf()
    {
        var request = new CertificateRequest("CN=gateway", _key, HashAlgorithmName.SHA256);
        var address = "http://" + _issuerServer.LocalEndpoint + "/issuer.cer";
        request.CertificateExtensions.Add(new X509AuthorityInformationAccessExtension([], [address]));
        return request.Create(_intermediate, DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow.AddDays(20), [4, 5, 6]);
    }
}
