using System;

namespace Nowpose.Pairing
{
    /// <summary>Kind of a code in view.</summary>
    enum PairingCodeKind
    {
        /// <summary>A code of another application; ignored.</summary>
        Foreign,

        /// <summary>A code of the robot's marker, see <see cref="CellCode"/>.</summary>
        Cell,

        /// <summary>A code of the gateway, which is valid only once, see <see cref="TokenCode"/>.</summary>
        Token,

        /// <summary>A pairing code of an unknown kind.</summary>
        Unknown,
    }

    /// <summary>Common format of the codes that pair a headset with a gateway: "nowpose:KIND/VERSION?a=…&amp;b=…" in printable ASCII.</summary>
    static class PairingCode
    {
        /// <summary>Start of every pairing code; other codes are ignored.</summary>
        public const string Scheme = "nowpose:";

        /// <summary>
        /// Maximum length of a code in characters: the capacity of a QR code of version 10 (57 modules per edge) at error correction level M,
        /// the largest version that HoloLens 2 detects.
        /// </summary>
        public const int MaxLength = 213;

        /// <summary>Returns the kind that a code declares. Reads only the beginning of the text and allocates nothing.</summary>
        public static PairingCodeKind KindOf(string text)
        {
            // Ignores case: a code in upper case is a pairing code too, and is rejected with a message.
            if (text == null || !text.StartsWith(Scheme, StringComparison.OrdinalIgnoreCase)) return PairingCodeKind.Foreign;
            if (StartsWith(text, CellCode.Kind)) return PairingCodeKind.Cell;
            return StartsWith(text, TokenCode.Kind) ? PairingCodeKind.Token : PairingCodeKind.Unknown;
        }

        static bool StartsWith(string text, string kind) =>
            string.CompareOrdinal(text, Scheme.Length, kind, 0, kind.Length) == 0
            && text.Length > Scheme.Length + kind.Length && text[Scheme.Length + kind.Length] == '/';
    }
}
