using System.Net;
using System.Security.Cryptography;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Options;

namespace Nowpose.Gateway.Security;

/// <summary>Loads, generates and saves the gateway's TLS certificate.</summary>
public static class CertificateFiles
{
    // Maximum validity that operating systems and browsers accept for a certificate that a user trusts manually.
    static readonly TimeSpan Validity = TimeSpan.FromDays(825);

    /// <summary>Generates a self-signed ECDSA P-256 certificate for this machine, in memory only. Each certificate has a new key and pin.</summary>
    /// <param name="hostNames">Other host names and addresses under which clients connect to this machine; null for none.</param>
    public static X509Certificate2 Generate(IReadOnlyList<string> hostNames = null) =>
        Generate(DateTimeOffset.UtcNow.AddDays(-1), DateTimeOffset.UtcNow + Validity, hostNames);

    /// <summary>Generates a certificate with the given period of validity.</summary>
    /// <inheritdoc cref="Generate(IReadOnlyList{string})" path="/param"/>
    public static X509Certificate2 Generate(DateTimeOffset from, DateTimeOffset to, IReadOnlyList<string> hostNames = null)
    {
        using var key = ECDsa.Create(ECCurve.NamedCurves.nistP256);
        var request = new CertificateRequest("CN=Nowpose gateway", key, HashAlgorithmName.SHA256);
        request.CertificateExtensions.Add(Names(hostNames ?? []));
        request.CertificateExtensions.Add(new X509BasicConstraintsExtension(false, false, 0, true));
        request.CertificateExtensions.Add(new X509KeyUsageExtension(X509KeyUsageFlags.DigitalSignature, true));
        request.CertificateExtensions.Add(new X509EnhancedKeyUsageExtension([new Oid("1.3.6.1.5.5.7.3.1")], false));
        using var certificate = request.CreateSelfSigned(from, to);
        return Usable(certificate);
    }

    /// <summary>Loads a .pfx file without a password or a .pem file. If the file does not exist, creates it with a new certificate.</summary>
    /// <param name="path">Path of the certificate's file.</param>
    /// <param name="keyPath">Path of the .pem file of the key; null if the key is in the certificate's file.</param>
    /// <param name="hostNames">Host names and addresses for a new certificate, in addition to those of this machine; null for none.</param>
    /// <exception cref="InputException">The file cannot be read, has no private key, or its certificate has expired.</exception>
    /// <exception cref="IOException">The certificate is not valid yet, according to this machine's clock.</exception>
    public static X509Certificate2 LoadOrGenerate(string path, string keyPath, IReadOnlyList<string> hostNames = null)
    {
        if (!File.Exists(path) && keyPath == null)
            Save(path, hostNames);
        return LoadValid(path, keyPath).Certificate;
    }

    /// <summary>Loads a .pfx file without a password or a .pem file.</summary>
    /// <inheritdoc cref="LoadOrGenerate"/>
    internal static ServerCertificate LoadValid(string path, string keyPath)
    {
        var certificate = Load(path, keyPath);
        var now = DateTime.Now;
        // A machine without a battery for its clock starts with an old time. A restart succeeds once the time is right.
        if (now < certificate.NotBefore) throw new IOException(KeyFileMessages.NotYetValid(path, certificate.NotBefore, now));
        if (now > certificate.NotAfter) throw new InputException(KeyFileMessages.Expired(path, certificate.NotAfter, now));
        return new ServerCertificate(certificate, All(path));
    }

    // Returns all certificates of the file: the gateway's own one and those of its issuers, if the file contains them. On Windows, a key that is not
    // ephemeral is copied to the profile of the user. macOS has no ephemeral keys.
    static X509Certificate2Collection All(string path) => Read(path, () =>
    {
        var keys = OperatingSystem.IsWindows() ? X509KeyStorageFlags.EphemeralKeySet : X509KeyStorageFlags.DefaultKeySet;
        if (IsPfx(path)) return X509CertificateLoader.LoadPkcs12CollectionFromFile(path, null, keys);
        var all = new X509Certificate2Collection();
        all.ImportFromPemFile(path);
        return all;
    });

    static X509Certificate2 Load(string path, string keyPath) => Read(path, () =>
    {
        if (IsPfx(path))
            return WithKey(X509CertificateLoader.LoadPkcs12FromFile(path, null), path);
        using var certificate = X509Certificate2.CreateFromPemFile(path, keyPath);
        return Usable(certificate);
    });

    static T Read<T>(string path, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or CryptographicException)
        {
            throw new InputException(KeyFileMessages.Unusable(path, e.Message), e);
        }
    }

    static X509Certificate2 WithKey(X509Certificate2 certificate, string path) => certificate.HasPrivateKey
        ? certificate : throw new InputException(KeyFileMessages.NoPrivateKey(path));

    static void Save(string path, IReadOnlyList<string> hostNames)
    {
        using var certificate = Generate(hostNames);
        var bytes = IsPfx(path) ? certificate.Export(X509ContentType.Pfx) : System.Text.Encoding.ASCII.GetBytes(Pem(certificate));
        FileFault.Report(() => OutputFile.CreateSecret(path, bytes), e => KeyFileMessages.NotWritten(path, e.Message));
    }

    static string Pem(X509Certificate2 certificate)
    {
        using var key = certificate.GetECDsaPrivateKey();
        return certificate.ExportCertificatePem() + "\n" + key.ExportPkcs8PrivateKeyPem() + "\n";
    }

    static bool IsPfx(string path) =>
        path.EndsWith(".pfx", StringComparison.OrdinalIgnoreCase) || path.EndsWith(".p12", StringComparison.OrdinalIgnoreCase);

    // Exports and imports the certificate, because TLS on Windows cannot use a key that exists in memory only.
    static X509Certificate2 Usable(X509Certificate2 certificate) =>
        X509CertificateLoader.LoadPkcs12(certificate.Export(X509ContentType.Pfx), null, X509KeyStorageFlags.Exportable);

    static X509Extension Names(IReadOnlyList<string> others)
    {
        var names = new SubjectAlternativeNameBuilder();
        var hosts = OwnHosts.MachineNames.Concat(others).Where(name => Uri.CheckHostName(name) == UriHostNameType.Dns).Prepend("localhost");
        foreach (var name in hosts.Distinct(StringComparer.OrdinalIgnoreCase)) names.AddDnsName(name);
        var addresses = OwnHosts.AddressesOfThisMachine().Append(IPAddress.Loopback).Append(IPAddress.IPv6Loopback)
            .Concat(others.Select(other => IPAddress.TryParse(other, out var address) ? address : null).OfType<IPAddress>());
        foreach (var address in addresses.Distinct()) names.AddIpAddress(address);
        return names.Build();
    }
}
