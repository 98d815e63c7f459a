using System;
using System.Globalization;
using System.Net.Security;
using System.Security.Cryptography.X509Certificates;
using Nowpose.Messages;
using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Checks whether a server's certificate belongs to the gateway. The check cannot be switched off.</summary>
    sealed class ServerTrust
    {
        readonly CertificatePin _pin;

        /// <param name="pin">The only trusted key; null to trust the device's certificate store.</param>
        public ServerTrust(CertificatePin pin) => _pin = pin;

        /// <returns>Reason why the certificate is rejected; null if it is trusted.</returns>
        /// <param name="certificate">The server's certificate; may be null.</param>
        /// <param name="errors">
        /// Result of the platform's own check. With a pin, only the pin and the dates are checked, because the gateway's certificate is
        /// usually self-signed.
        /// </param>
        /// <param name="now">The device's time of day.</param>
        public string Refusal(X509Certificate certificate, SslPolicyErrors errors, DateTime now)
        {
            if (certificate == null) return CertificateMessages.None;
            if (_pin == null) return DeviceRefusal(errors);
            if (!_pin.Matches(certificate))
                return CertificateMessages.OtherPin(CertificatePin.Of(certificate), _pin);
            return DatesRefusal(certificate, now);
        }

        static string DeviceRefusal(SslPolicyErrors errors)
        {
            if (errors == SslPolicyErrors.None) return null;
            // A certificate that also lacks the device's trust must first be installed.
            return errors == SslPolicyErrors.RemoteCertificateNameMismatch ? CertificateMessages.OtherName : CertificateMessages.NotTrusted(errors);
        }

        static string DatesRefusal(X509Certificate certificate, DateTime now)
        {
            using (var full = new X509Certificate2(certificate))
            {
                if (now > full.NotAfter) return CertificateMessages.Expired(Day(full.NotAfter));
                if (now < full.NotBefore) return CertificateMessages.NotYetValid(Day(full.NotBefore));
                return null;
            }
        }

        static string Day(DateTime moment) => moment.ToString("yyyy-MM-dd HH:mm", CultureInfo.InvariantCulture);
    }
}
