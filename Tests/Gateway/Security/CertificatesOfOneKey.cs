using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;

namespace Nowpose.Headless.Tests.Gateway.Security;

/// <summary>Creates renewed certificates, which have other dates but the same key and therefore the same pin.</summary>
static class CertificatesOfOneKey
{
    /// <summary>Writes a .pem file with a key and a certificate that is valid for the given number of days from now.</summary>
    public static void Write(string path, ECDsa key, double days) => Write(path, key, DateTimeOffset.UtcNow.AddDays(days));

    public static void Write(string path, ECDsa key, DateTimeOffset until)
    {
        var request = new CertificateRequest("CN=gateway", key, HashAlgorithmName.SHA256);
        using var certificate = request.CreateSelfSigned(DateTimeOffset.UtcNow.AddDays(-1), until);
        // Replaces the file in one step, because the gateway may read it at any moment.
        File.WriteAllText(path + ".new", certificate.ExportCertificatePem() + "\n" + key.ExportPkcs8PrivateKeyPem() + "\n");
        File.Move(path + ".new", path, overwrite: true);
    }
}
