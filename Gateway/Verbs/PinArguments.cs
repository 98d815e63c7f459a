using System.CommandLine;
using Nowpose.Gateway.Options;
using Nowpose.Gateway.Security;

namespace Nowpose.Gateway.Verbs;

/// <summary>The options that identify a gateway's key, either by its certificate or by the pin that the gateway prints.</summary>
sealed class PinArguments
{
    readonly Option<string> _certificate = TextOption.Create("--certificate", "Certificate with which the gateway was started", "FILE");
    readonly Option<string> _key = TextOption.Create("--certificate-key", ".pem file of the private key, if separate", "FILE");
    readonly Option<string> _pin = TextOption.Create("--pin", "Pin that the gateway prints, instead of the certificate", "PIN");

    public void AddTo(Command command)
    {
        command.Options.Add(_certificate);
        command.Options.Add(_key);
        command.Options.Add(_pin);
    }

    /// <summary>Gets the pin; null for a gateway without TLS.</summary>
    /// <exception cref="InputException">The file or the pin is invalid, or both are given.</exception>
    public CertificatePin Read(ParseResult parsed)
    {
        var path = parsed.GetValue(_certificate);
        var pin = parsed.GetValue(_pin);
        if (path != null && pin != null)
            throw new InputException(VerbMessages.PinAndCertificate);
        if (pin != null)
            return CertificatePin.Parse(pin);
        if (path == null)
            return null;
        // Does not create a missing certificate, because the printed marker is used for years and must contain the pin of the gateway's actual key.
        if (!File.Exists(path))
            throw new InputException(VerbMessages.NoCertificate(path));
        using var certificate = CertificateFiles.LoadOrGenerate(path, parsed.GetValue(_key));
        return CertificatePin.Of(certificate);
    }
}
