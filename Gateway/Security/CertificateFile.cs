using System.Security.Cryptography.X509Certificates;
using Nowpose.Protocol;

namespace Nowpose.Gateway.Security;

/// <summary>The gateway's certificate, followed in its file: a renewed one is shown to whoever connects next. Any thread.</summary>
/// <remarks>Only one with the same key is taken: headsets pin the key, and would refuse another without a word to the gateway.</remarks>
public sealed class CertificateFile
{
    // Certificate and key are two files sometimes, which are not written at one moment.
    static readonly TimeSpan Settles = TimeSpan.FromMilliseconds(500);

    readonly FollowedFile<X509Certificate2> _file;
    readonly CertificatePin _pin;
    readonly string _path;
    readonly string _keyPath;

    /// <param name="path">A .pfx or .pem file; a new certificate is made there when there is none.</param>
    /// <param name="keyPath">The .pem file of the key when it is not in the certificate's own; null otherwise.</param>
    /// <param name="log">Is told when the file cannot be used any more; null for nobody.</param>
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

    /// <summary>Of the file that holds the private key.</summary>
    internal string KeyPath => _keyPath ?? _path;

    X509Certificate2 Load(string path, string keyPath)
    {
        var certificate = CertificateFiles.LoadValid(path, keyPath);
        var pin = CertificatePin.Of(certificate);
        if (pin.Equals(_pin)) return certificate;
        certificate.Dispose();
        throw new InputException($"{path}: has another key (pin {pin}), which no headset expects; restart the gateway to use it");
    }
}
