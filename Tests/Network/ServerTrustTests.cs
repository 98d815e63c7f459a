using System.Net.Security;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Messages;
using Nowpose.Network;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Network;

public class ServerTrustTests
{
    [Test]
    public void Refusal_TrustedByTheDevice_IsNull() => Assert.That(RefusalFor(SslPolicyErrors.None), Is.Null);

    [Test]
    public void Refusal_OnlyTheNameDiffers_NamesTheHost() =>
        Assert.That(RefusalFor(SslPolicyErrors.RemoteCertificateNameMismatch), Is.EqualTo(CertificateMessages.OtherName));

    [TestCase(SslPolicyErrors.RemoteCertificateChainErrors)]
    [TestCase(SslPolicyErrors.RemoteCertificateChainErrors | SslPolicyErrors.RemoteCertificateNameMismatch)]
    public void Refusal_NotTrustedByTheDevice_NamesTheErrors(SslPolicyErrors errors) =>
        Assert.That(RefusalFor(errors), Is.EqualTo(CertificateMessages.NotTrusted(errors)));

    static string RefusalFor(SslPolicyErrors errors)
    {
        using var key = ECDsa.Create();
        using var certificate = new CertificateRequest("CN=gateway", key, HashAlgorithmName.SHA256)
            .CreateSelfSigned(DateTimeOffset.UnixEpoch, DateTimeOffset.UnixEpoch.AddDays(1));
        return new ServerTrust(pin: null).Refusal(certificate, errors, DateTime.UnixEpoch);
    }
}
