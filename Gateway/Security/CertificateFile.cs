namespace Nowpose.Gateway.Security;

/// <summary>The gateway's certificate, which follows changes of its file, so that new connections use a renewed certificate. Thread-safe.</summary>
/// <remarks>
/// A certificate with another key is not used, because headsets pin the key and would refuse the certificate without informing the gateway.
/// </remarks>
public sealed class CertificateFile
{
    // Time in which a renewal writes both files, if certificate and key are in separate files.
    static readonly TimeSpan Settles = TimeSpan.FromMilliseconds(500);

    readonly FollowedFile<ServerCertificate> _file;
    readonly CertificatePin _pin;
    readonly string _path;
    readonly string _keyPath;

    /// <param name="path">Path of a .pfx or .pem file. If the file does not exist, it is created with a new certificate.</param>
    /// <param name="keyPath">Path of the .pem file of the key; null if the key is in the certificate's file.</param>
    /// <param name="log">Receives a line when the file becomes invalid, and when it was renewed; null for no log.</param>
    /// <inheritdoc cref="CertificateFiles.LoadOrGenerate"/>
    public CertificateFile(string path, string keyPath, Action<string> log, IReadOnlyList<string> hostNames = null)
    {
        using (var first = CertificateFiles.LoadOrGenerate(path, keyPath, hostNames))
            _pin = CertificatePin.Of(first);
        (_path, _keyPath) = (path, keyPath);
        _file = new FollowedFile<ServerCertificate>([path, keyPath], (out string fault) =>
        {
            fault = null;
            return Load(path, keyPath);
        }, Settles, log, (former, renewed) =>
        {
            if (former.Certificate.NotAfter != renewed.Certificate.NotAfter)
                log?.Invoke(KeyFileMessages.Renewed(renewed.Certificate.NotAfter.ToUniversalTime()));
        });
    }

    internal ServerCertificate Current => _file.Current;

    /// <summary>Path of the certificate's file.</summary>
    internal string Path => _path;

    /// <inheritdoc cref="FollowedFile{T}.Fault"/>
    internal string Fault => _file.Fault;

    /// <summary>Path of the file that contains the private key.</summary>
    internal string KeyPath => _keyPath ?? _path;

    ServerCertificate Load(string path, string keyPath)
    {
        var loaded = CertificateFiles.LoadValid(path, keyPath);
        var pin = CertificatePin.Of(loaded.Certificate);
        if (!pin.Equals(_pin))
        {
            loaded.Certificate.Dispose();
            throw new InputException(KeyFileMessages.OtherKey(path, pin));
        }

        return loaded;
    }
}
