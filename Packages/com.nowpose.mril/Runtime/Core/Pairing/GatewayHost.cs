using System;
using System.Globalization;
using System.Net;
using System.Net.Sockets;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>Checks the host of a gateway in a code, so that the host shown to the wearer is the host to which the headset connects.</summary>
    static class GatewayHost
    {
        const int MaxNameLength = 100, MaxLabelLength = 63;

        /// <returns>The host in lower case.</returns>
        /// <exception cref="InputException">
        /// The host is neither a name of ASCII letters, digits and hyphens, nor an address in its usual form.
        /// </exception>
        public static string Require(string host, string what)
        {
            var plain = (host ?? "").ToLowerInvariant();
            if (plain.Contains(':') ? IsIPv6(plain) : IsNumeric(plain) ? IsIPv4(plain) : IsName(plain)) return plain;
            throw new InputException(PairingCodeMessages.NotAHost(what, Shown(host)));
        }

        static bool IsName(string host)
        {
            if (host.Length == 0 || host.Length > MaxNameLength) return false;
            foreach (var label in host.Split('.'))
                if (!IsLabel(label)) return false;
            return true;
        }

        static bool IsLabel(string label)
        {
            if (label.Length == 0 || label.Length > MaxLabelLength || label[0] == '-' || label[label.Length - 1] == '-') return false;
            foreach (var c in label)
                if (!((c >= 'a' && c <= 'z') || IsDigit(c) || c == '-')) return false;
            return true;
        }

        // Some resolvers accept 10.1, 012.0.0.1 and 0x7f.1 as addresses, so a host that ends in a number must be a full IPv4 address.
        static bool IsNumeric(string host)
        {
            var last = host.Substring(host.LastIndexOf('.') + 1);
            return last.Length > 0 && IsDigit(last[0])
                && (last.StartsWith("0x", StringComparison.Ordinal) || Array.TrueForAll(last.ToCharArray(), IsDigit));
        }

        static bool IsIPv4(string host)
        {
            var parts = host.Split('.');
            if (parts.Length != 4) return false;
            foreach (var part in parts)
                if (!byte.TryParse(part, NumberStyles.None, CultureInfo.InvariantCulture, out var value)
                    || part != value.ToString(CultureInfo.InvariantCulture)) return false;
            return host != "0.0.0.0";
        }

        static bool IsIPv6(string host)
        {
            foreach (var c in host)
                if (!((c >= 'a' && c <= 'f') || IsDigit(c) || c == ':' || c == '.')) return false;
            return IPAddress.TryParse(host, out var address) && address.AddressFamily == AddressFamily.InterNetworkV6
                && !address.Equals(IPAddress.IPv6Any);
        }

        static bool IsDigit(char c) => c >= '0' && c <= '9';

        // A rejected host may contain any characters, including Unity's rich-text tags.
        static string Shown(string host)
        {
            var shown = (host ?? "").ToCharArray();
            for (var i = 0; i < shown.Length; i++)
                if (shown[i] < ' ' || shown[i] > '~' || shown[i] == '<') shown[i] = '?';
            return new string(shown, 0, Math.Min(shown.Length, MaxNameLength));
        }
    }
}
