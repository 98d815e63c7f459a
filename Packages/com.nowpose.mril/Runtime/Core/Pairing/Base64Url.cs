using System;

namespace Nowpose.Pairing
{
    /// <summary>Base64 with - and _ and without padding (RFC 4648, section 5). Accepts only the canonical form.</summary>
    static class Base64Url
    {
        public static string Write(ReadOnlySpan<byte> bytes) =>
            Convert.ToBase64String(bytes).TrimEnd('=').Replace('+', '-').Replace('/', '_');

        /// <returns>True only if the text is the result of <see cref="Write"/> for that number of bytes.</returns>
        public static bool TryRead(string text, int length, out byte[] bytes)
        {
            bytes = new byte[length];
            if (text.Length != (length * 4 + 2) / 3) return false;
            var padded = text.Replace('-', '+').Replace('_', '/') + new string('=', (4 - text.Length % 4) % 4);
            // Encodes again to reject other forms: nonzero bits after the last byte, and the standard alphabet.
            return Convert.TryFromBase64String(padded, bytes, out var read) && read == length && Write(bytes) == text;
        }
    }
}
