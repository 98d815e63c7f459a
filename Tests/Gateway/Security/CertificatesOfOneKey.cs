using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Certificates as whoever renews them makes them: other dates, the same key, and so the same pin.</summary>
static class CertificatesOfOneKey
{
    /// <summary>Writes a .pem file with certificate and key, valid until so many days from now.</summary>
    public static void Write(string path, ECDsa key, double days) => Write(path, key, DateTimeOffset.UtcNow.AddDays(days));

    public static void Write(string path, ECDsa key, DateTimeOffset until)
    {
        var request = new CertificateRequest("CN=gateway", key, HashAlgorithmName.SHA256);
        using var certificate = request.CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), until);
        // As a whole: the gateway may look at any moment.
        File.WriteAllText(path + ".new", certificate.ExportCertificatePem() + "\n" + key.ExportPkcs8PrivateKeyPem() + "\n");
        File.Move(path + ".new", path, overwrite: true);
    }
}
