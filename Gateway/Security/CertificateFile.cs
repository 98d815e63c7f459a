using System.Security.Cryptography.X509Certificates;
using Nowpose.Gateway.Messages;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Security;

/// <summary>The gateway's certificate, updated from its file: new connections get a renewed one. Thread-safe.</summary>
/// <remarks>Only a certificate with the same key is used. Headsets pin the key, and would refuse another one without informing the gateway.</remarks>
public sealed class CertificateFile
{
    // Certificate and key may be two files, which are not written at the same instant.
    static readonly TimeSpan Settles = TimeSpan.FromMilliseconds(500);

    readonly FollowedFile<X509Certificate2> _file;
    readonly CertificatePin _pin;
    readonly string _path;
    readonly string _keyPath;

    /// <param name="path">A .pfx or .pem file; a new certificate is created there if the file does not exist.</param>
    /// <param name="keyPath">The .pem file of the key if it is not in the certificate's file; null otherwise.</param>
    /// <param name="log">Receives a line when the file becomes invalid; null for none.</param>
    /// <exception cref="InputException">The file cannot be read, has no private key, or is not valid now.</exception>
    public CertificateFile(string path, string keyPath, Action<string> log)
    {
        using (var first = CertificateFiles.LoadOrGenerate(path, keyPath))
            _pin = CertificatePin.Of(first);
        (_path, _keyPath) = (path, keyPath);
        _file = new FollowedFile<X509Certificate2>([path, keyPath], (out string fault) =>
        {
            fault = null;
            return Load(path, keyPath);
        }, Settles, log);
    }

    internal X509Certificate2 Current => _file.Current;

    /// <summary>Path of the file that contains the private key.</summary>
    internal string KeyPath => _keyPath ?? _path;

    X509Certificate2 Load(string path, string keyPath)
    {
        var certificate = CertificateFiles.LoadValid(path, keyPath);
        var pin = CertificatePin.Of(certificate);
        if (pin.Equals(_pin)) return certificate;
        certificate.Dispose();
        throw new InputException(KeyFileMessages.OtherKey(path, pin));
    }
}
