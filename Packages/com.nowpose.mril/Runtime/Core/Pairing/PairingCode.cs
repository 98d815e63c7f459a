using System;

namespace Nowpose.Pairing
{
    /// <summary>What the codes that pair a headset with a gateway have in common: "nowpose:KIND/VERSION?a=…&amp;b=…" in printable ASCII.</summary>
    static class PairingCode
    {
        /// <summary>Codes that begin otherwise are not ours.</summary>
        public const string Scheme = "nowpose:";

        /// <summary>
        /// Longest code: what a QR code of version 10 (57 modules an edge) holds at error correction M, the greatest version
        /// that HoloLens 2 finds.
        /// </summary>
        public const int GreatestLength = 213;

        /// <summary>What a code says it is. Looks at its beginning only, however long it is, and allocates nothing.</summary>
        public static PairingCodeKind KindOf(string text)
        {
            // Whatever its case: an upper-case one is ours, and refused in words.
            if (text == null || !text.StartsWith(Scheme, StringComparison.OrdinalIgnoreCase)) return PairingCodeKind.Foreign;
            if (StartsWith(text, CellCode.Kind)) return PairingCodeKind.Cell;
            return StartsWith(text, TokenCode.Kind) ? PairingCodeKind.Token : PairingCodeKind.Unknown;
        }

        static bool StartsWith(string text, string kind) =>
            string.CompareOrdinal(text, Scheme.Length, kind, 0, kind.Length) == 0
            && text.Length > Scheme.Length + kind.Length && text[Scheme.Length + kind.Length] == '/';
    }
}
