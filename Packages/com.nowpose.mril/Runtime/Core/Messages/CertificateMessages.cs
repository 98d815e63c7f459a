using System.Net.Security;
using Nowpose.Protocol;

namespace Nowpose.Messages
{
    /// <summary>Reasons to refuse a gateway's certificate, with remedies.</summary>
    static class CertificateMessages
    {
        public const string None = "certificate: the gateway presented none; start it with --tls or --certificate";

        public static string NotTrusted(SslPolicyErrors errors) =>
            $"certificate: not trusted by this device ({errors}); install it on this device, or enter its pin";

        public const string OtherName =
            "certificate: trusted by this device, but issued for another name than Host; enter a name of the certificate as Host, or enter its pin";

        public static string OtherPin(CertificatePin pin, CertificatePin expected) =>
            $"certificate: its pin is {pin}, but {expected} is expected; compare it with the pin that the gateway prints: if they are equal, pair "
            + "again or correct the pin; otherwise, this is another server, or a firewall decrypts TLS";

        public static string Expired(string day) => $"certificate: expired on {day}; renew it on the gateway";
        public static string NotYetValid(string day) => $"certificate: not valid before {day}; check this device's date";

        public static string PinInvalid(string text) =>
            $"certificate pin \"{text}\" is not the base64 of 32 bytes; copy it as the gateway prints it (sha256/…=)";

        public const string NotX509 =
            "certificate: its bytes are not those of an X.509 certificate, so it has no public key to pin; use a certificate in PEM or DER format";
    }
}
