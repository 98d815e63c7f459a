using System;

namespace Nowpose.Pairing
{
    /// <summary>Bytes as base64 with - and _ and without padding (RFC 4648, section 5), each in one form only.</summary>
    static class Base64Url
    {
        public static string Write(ReadOnlySpan<byte> bytes) =>
            Convert.ToBase64String(bytes).TrimEnd('=').Replace('+', '-').Replace('/', '_');

        /// <returns>False for anything but what <see cref="Write"/> makes of so many bytes.</returns>
        public static bool TryRead(string text, int length, out byte[] bytes)
        {
            bytes = new byte[length];
            if (text.Length != (length * 4 + 2) / 3) return false;
            var padded = text.Replace('-', '+').Replace('_', '/') + new string('=', (4 - text.Length % 4) % 4);
            // Written again: bits beyond the last byte, and the other alphabet, would be a second form.
            return Convert.TryFromBase64String(padded, bytes, out var read) && read == length && Write(bytes) == text;
        }
    }
}
