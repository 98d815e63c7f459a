using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using NUnit.Framework;
using Nowpose.Protocol;

namespace Nowpose.Headless.Tests.Protocol;

public class CertificatePinOfCertificateTests
{
    static CertificateRequest Rsa(string name)
    {
        var key = RSA.Create(2048);
        return new CertificateRequest("CN=" + name, key, HashAlgorithmName.SHA256, RSASignaturePadding.Pkcs1);
    }

    static CertificateRequest EcDsa(string name) =>
        new("CN=" + name, ECDsa.Create(ECCurve.NamedCurves.nistP256), HashAlgorithmName.SHA256);

    static X509Certificate2 Sign(CertificateRequest request) =>
        request.CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow.AddDays(1));

    [TestCase("rsa")]
    [TestCase("ecdsa")]
    public void Of_Certificate_EqualsTheHashOfTheExportedKey(string algorithm)
    {
        using var certificate = Sign(algorithm == "rsa" ? Rsa("cell 1") : EcDsa(new string('n', 60)));
        var expected = "sha256/" + Convert.ToBase64String(SHA256.HashData(certificate.PublicKey.ExportSubjectPublicKeyInfo()));

        var pin = CertificatePin.Of(certificate);

        Assert.That(pin.ToString(), Is.EqualTo(expected));
        Assert.That(CertificatePin.Parse(expected).Matches(certificate), Is.True);
    }

    [Test]
    public void Matches_CertificateRenewedWithTheSameKey_IsTrue()
    {
        var request = EcDsa("a");
        using var first = Sign(request);
        using var second = Sign(request);

        Assert.That(first.Equals(second), Is.False);
        Assert.That(CertificatePin.Of(first).Matches(second), Is.True);
    }

    [Test]
    public void Matches_OtherKeyWithTheSameName_IsFalse()
    {
        using var first = Sign(EcDsa("a"));
        using var second = Sign(EcDsa("a"));

        Assert.That(CertificatePin.Of(first).Matches(second), Is.False);
    }
}
