using System;
using System.Globalization;
using System.Text;
using Nowpose.Messages;

namespace Nowpose.Pairing
{
    /// <summary>Checks and encodes cell names. Rejects characters that could change the appearance of a question to the wearer.</summary>
    static class CellName
    {
        public const int MaxLength = 40;

        /// <summary>Invisible letters and marks: fillers, inherent vowels and variation selectors.</summary>
        const string Invisible = "\u115F\u1160\u17B4\u17B5\u180B\u180C\u180D\u180F\u3164\uFFA0";

        // Strict: rejects invalid UTF-8 instead of replacing it.
        static readonly UTF8Encoding Utf8 = new UTF8Encoding(false, true);

        /// <exception cref="InputException">The name is empty, too long, or contains a character that is not allowed.</exception>
        public static string Require(string name, string what)
        {
            if (string.IsNullOrEmpty(name) || name.Length > MaxLength)
                throw new InputException(PairingCodeMessages.NameLength(what, name?.Length ?? 0, MaxLength));
            for (var i = 0; i < name.Length; i++)
                if (!IsAllowed(name[i]))
                    throw new InputException(PairingCodeMessages.NameCharacter(what, i + 1, (int)name[i]));
            if (name[0] == ' ' || name[name.Length - 1] == ' ') throw new InputException(PairingCodeMessages.NameSpace(what));
            return name;
        }

        /// <summary>Decodes a name from a code: percent-encoded UTF-8 except ASCII letters, digits, -, _ and full stops.</summary>
        /// <exception cref="InputException">The text is not encoded like this (hexadecimal digits may have either case), or the name is not allowed.</exception>
        public static string Decode(string text, string what)
        {
            var bytes = new byte[text.Length];
            var length = 0;
            for (var i = 0; i < text.Length; i++)
            {
                if (text[i] == '%' && i + 2 < text.Length && Uri.IsHexDigit(text[i + 1]) && Uri.IsHexDigit(text[i + 2]))
                {
                    bytes[length++] = (byte)(Uri.FromHex(text[i + 1]) * 16 + Uri.FromHex(text[i + 2]));
                    i += 2;
                }
                else if (IsUnreserved(text[i])) bytes[length++] = (byte)text[i];
                else throw new InputException(PairingCodeMessages.NotEncoded(what, i + 1));
            }
            try
            {
                return Require(Utf8.GetString(bytes, 0, length), what);
            }
            catch (DecoderFallbackException)
            {
                throw new InputException(PairingCodeMessages.NotUtf8(what));
            }
        }

        // Excludes angle brackets, which delimit tags in Unity's rich text; control, format and direction characters; and surrogate pairs.
        static bool IsAllowed(char c)
        {
            if (Invisible.Contains(c) || (c >= '\uFE00' && c <= '\uFE0F')) return false;
            // Excludes combining accents, because names that look the same must be equal, and devices differ in the normalisation that they support.
            if (c >= '\u0300' && c <= '\u036F') return false;
            switch (char.GetUnicodeCategory(c))
            {
                case UnicodeCategory.UppercaseLetter:
                case UnicodeCategory.LowercaseLetter:
                case UnicodeCategory.TitlecaseLetter:
                case UnicodeCategory.ModifierLetter:
                case UnicodeCategory.OtherLetter:
                case UnicodeCategory.NonSpacingMark:
                case UnicodeCategory.SpacingCombiningMark:
                case UnicodeCategory.DecimalDigitNumber:
                    return true;
                default:
                    return c == ' ' || c == '-' || c == '_' || c == '.';
            }
        }

        static bool IsUnreserved(char c) =>
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.';
    }
}
