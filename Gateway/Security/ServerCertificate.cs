using System.Net.Security;
using System.Security.Authentication;
using System.Security.Cryptography.X509Certificates;

namespace Nowpose.Gateway.Security;

/// <summary>The gateway's certificate and the issuers that both ports send with it. Thread-safe.</summary>
/// <remarks>
/// The issuers are those in the certificate's file and in the machine's store. Without a fixed chain, .NET would try to download missing issuers in
/// each handshake, which takes 15 s on a network without internet, longer than clients wait.
/// </remarks>
sealed class ServerCertificate
{
    readonly Lazy<SslStreamCertificateContext> _chain;

    /// <param name="certificate">The certificate with its private key.</param>
    /// <param name="issuers">Certificates among which its issuers are, in any order; may be empty.</param>
    public ServerCertificate(X509Certificate2 certificate, X509Certificate2Collection issuers)
    {
        Certificate = certificate;
        _chain = new Lazy<SslStreamCertificateContext>(() => SslStreamCertificateContext.Create(certificate, issuers, offline: true));
    }

    public X509Certificate2 Certificate { get; }

    /// <summary>Gets the settings of a TLS connection that a client opens.</summary>
    public SslServerAuthenticationOptions ForConnection() => new()
    {
        ServerCertificateContext = _chain.Value,
        EnabledSslProtocols = SslProtocols.Tls12 | SslProtocols.Tls13,
    };
}
