using System.Net.NetworkInformation;
using System.Net.Sockets;
using System.Security.Cryptography.X509Certificates;
using NUnit.Framework;
using Nowpose.Gateway.Security;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Gateway;

public class CertificateFilesTests
{
    string _folder;

    [SetUp]
    public void SetUp() => _folder = Directory.CreateTempSubdirectory("nowpose-certificate").FullName;

    [TearDown]
    public void TearDown() => Directory.Delete(_folder, true);

    [TestCase("gateway.pfx")]
    [TestCase("gateway.pem")]
    public void LoadOrGenerate_Twice_KeepsTheKey(string name)
    {
        var path = Path.Combine(_folder, name);

        using var first = CertificateFiles.LoadOrGenerate(path, null);
        using var second = CertificateFiles.LoadOrGenerate(path, null);

        Assert.That(first.HasPrivateKey && second.HasPrivateKey, Is.True);
        Assert.That(CertificatePin.Of(first), Is.EqualTo(CertificatePin.Of(second)));
        if (!OperatingSystem.IsWindows())
            Assert.That(File.GetUnixFileMode(path), Is.EqualTo(UnixFileMode.UserRead | UnixFileMode.UserWrite));
    }

    [Test]
    public void Generate_Twice_CreatesDifferentKeys()
    {
        using var first = CertificateFiles.Generate();
        using var second = CertificateFiles.Generate();

        Assert.That(CertificatePin.Of(first), Is.Not.EqualTo(CertificatePin.Of(second)));
        Assert.That(first.MatchesHostname("localhost"), Is.True);
    }

    [Test]
    public void Generate_OnThisMachine_NamesItsAddresses()
    {
        var addresses = NetworkInterface.GetAllNetworkInterfaces().Where(one => one.OperationalStatus == OperationalStatus.Up)
            .SelectMany(one => one.GetIPProperties().UnicastAddresses).Select(one => one.Address)
            .Where(address => address.AddressFamily == AddressFamily.InterNetwork).ToArray();

        using var certificate = CertificateFiles.Generate();

        Assert.That(certificate.Extensions.OfType<X509SubjectAlternativeNameExtension>().Single().EnumerateIPAddresses(), Is.SupersetOf(addresses));
    }

    [Test]
    public void LoadOrGenerate_OtherHostNames_ContainsNamesAndAddresses()
    {
        string[] names = ["edge1.plant.example", "192.0.2.7", "2001:db8::7"];

        using var certificate = CertificateFiles.LoadOrGenerate(Path.Combine(_folder, "new.pem"), null, names);

        foreach (var name in names.Append("localhost")) Assert.That(certificate.MatchesHostname(name), name);
        Assert.That(certificate.MatchesHostname("203.0.113.8"), Is.False);
    }

    [Test]
    public void LoadOrGenerate_Expired_ThrowsWithTheDate()
    {
        var path = Path.Combine(_folder, "old.pfx");
        using var old = CertificateFiles.Generate(
            new DateTimeOffset(2020, 1, 1, 0, 0, 0, TimeSpan.Zero), new DateTimeOffset(2021, 1, 2, 12, 0, 0, TimeSpan.Zero));
        File.WriteAllBytes(path, old.Export(X509ContentType.Pfx));

        var error = Assert.Throws<InputException>(() => CertificateFiles.LoadOrGenerate(path, null));

        Assert.That(error.Message, Does.Contain(path).And.Contain("2021-01-02"));
    }

    [Test]
    public void LoadOrGenerate_NotValidYet_ThrowsAnErrorThatARestartMayCorrect()
    {
        var path = Path.Combine(_folder, "early.pfx");
        using var early = CertificateFiles.Generate(DateTimeOffset.UtcNow.AddDays(2), DateTimeOffset.UtcNow.AddDays(20));
        File.WriteAllBytes(path, early.Export(X509ContentType.Pfx));

        var error = Assert.Throws<IOException>(() => CertificateFiles.LoadOrGenerate(path, null));

        Assert.That(error.Message, Does.Contain(early.NotBefore.ToString("yyyy-MM-dd")).And.Contain("clock"));
    }

    [TestCase("bad.pfx")]
    [TestCase("bad.pem")]
    public void LoadOrGenerate_FileIsNotACertificate_ThrowsWithAOneLineMessage(string name)
    {
        var path = Path.Combine(_folder, name);
        File.WriteAllText(path, "not a certificate");

        var error = Assert.Throws<InputException>(() => CertificateFiles.LoadOrGenerate(path, null));

        Assert.That(error.Message, Does.Contain(path).And.Not.Contain("\n"));
    }

    [Test]
    public void LoadOrGenerate_DamagedIssuer_ThrowsWithThePath()
    {
        var path = Path.Combine(_folder, "damaged.pem");
        using (CertificateFiles.LoadOrGenerate(path, null)) File.AppendAllText(path, "-----BEGIN CERTIFICATE-----\nAAAA\n-----END CERTIFICATE-----\n");

        var error = Assert.Throws<InputException>(() => CertificateFiles.LoadOrGenerate(path, null));

        Assert.That(error.Message, Does.Contain(path));
    }

    [Test]
    public void LoadOrGenerate_CertificateWithoutKey_Throws()
    {
        var path = Path.Combine(_folder, "public.pem");
        using var whole = CertificateFiles.Generate();
        File.WriteAllText(path, whole.ExportCertificatePem());

        Assert.Throws<InputException>(() => CertificateFiles.LoadOrGenerate(path, null));
    }
}
