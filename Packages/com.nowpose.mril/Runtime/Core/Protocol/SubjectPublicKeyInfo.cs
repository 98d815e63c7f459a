using System;

namespace Nowpose.Protocol
{
    /// <summary>Finds the SubjectPublicKeyInfo in a DER certificate (RFC 5280, 4.1); checks every length.</summary>
    static class SubjectPublicKeyInfo
    {
        const byte Sequence = 0x30;
        const byte ExplicitVersion = 0xA0;

        /// <param name="info">The key with its tag and length: the bytes from which a pin is computed.</param>
        public static bool TryFind(ReadOnlySpan<byte> certificate, out ReadOnlySpan<byte> info)
        {
            info = default;
            if (!TryTake(ref certificate, out var tag, out var body, out _) || tag != Sequence ||
                !TryTake(ref body, out tag, out var fields, out _) || tag != Sequence)
                return false;
            // Order of the fields: [version], serial number, signature algorithm, issuer, validity, subject.
            var before = fields.Length > 0 && fields[0] == ExplicitVersion ? 6 : 5;
            for (var i = 0; i < before; i++)
            {
                if (!TryTake(ref fields, out _, out _, out _))
                    return false;
            }

            return TryTake(ref fields, out tag, out _, out info) && tag == Sequence;
        }

        static bool TryTake(ref ReadOnlySpan<byte> rest, out byte tag, out ReadOnlySpan<byte> content, out ReadOnlySpan<byte> whole)
        {
            tag = 0;
            content = whole = default;
            if (!TryReadLength(rest, out var header, out var length) || length > rest.Length - header)
                return false;
            tag = rest[0];
            content = rest.Slice(header, length);
            whole = rest.Slice(0, header + length);
            rest = rest.Slice(header + length);
            return true;
        }

        // Short form: one byte below 0x80. Long form: 0x80 + n, then n bytes; three are sufficient for a certificate.
        static bool TryReadLength(ReadOnlySpan<byte> bytes, out int header, out int length)
        {
            header = 2;
            length = 0;
            if (bytes.Length < 2)
                return false;
            length = bytes[1];
            if (length < 0x80)
                return true;
            var count = length - 0x80;
            header += count;
            length = 0;
            if (count < 1 || count > 3 || bytes.Length < header)
                return false;
            foreach (var digit in bytes.Slice(2, count))
                length = length << 8 | digit;
            return true;
        }
    }
}
