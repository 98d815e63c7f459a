using System;
using System.Text;

namespace Nowpose.Protocol
{
    /// <summary>The received content of a JSON string between its quotation marks: valid UTF-8 with valid escapes.</summary>
    readonly ref struct JsonText
    {
        JsonText(ReadOnlySpan<byte> raw, bool isEscaped)
        {
            Raw = raw;
            IsEscaped = isEscaped;
        }

        public ReadOnlySpan<byte> Raw { get; }

        public bool IsEscaped { get; }

        /// <param name="text">JSON that begins after the opening quotation mark.</param>
        public static bool TryScan(ReadOnlySpan<byte> text, out JsonText scanned)
        {
            scanned = default;
            var isEscaped = false;
            for (var at = 0; at < text.Length;)
            {
                var first = text[at];
                var length = 1;
                if (first == '"')
                {
                    scanned = new JsonText(text.Slice(0, at), isEscaped);
                    return true;
                }

                if (first < ' ') return false;
                if (first == '\\')
                {
                    isEscaped = true;
                    length = EscapeLength(text.Slice(at));
                }
                else if (first >= 0x80)
                {
                    length = SequenceLength(text.Slice(at));
                }

                if (length == 0) return false;
                at += length;
            }

            return false;
        }

        /// <summary>Returns the text in UTF-8, without escapes.</summary>
        public byte[] Unescaped() => Encoding.UTF8.GetBytes(ToString());

        /// <summary>Returns the text; unpaired surrogates become U+FFFD.</summary>
        public override string ToString() => IsEscaped ? Unescape() : Encoding.UTF8.GetString(Raw);

        string Unescape()
        {
            var letters = new char[Raw.Length];
            var count = 0;
            for (var at = 0; at < Raw.Length;)
            {
                var rest = Raw.Slice(at);
                var run = rest.IndexOf((byte)'\\');
                if (run == 0)
                {
                    letters[count++] = Escaped(rest);
                    run = EscapeLength(rest);
                }
                else
                {
                    if (run < 0) run = rest.Length;
                    count += Encoding.UTF8.GetChars(rest.Slice(0, run), letters.AsSpan(count));
                }

                at += run;
            }

            ReplaceLoneSurrogates(letters.AsSpan(0, count));
            return new string(letters, 0, count);
        }

        static void ReplaceLoneSurrogates(Span<char> letters)
        {
            for (var i = 0; i < letters.Length; i++)
            {
                if (!char.IsSurrogate(letters[i])) continue;
                if (i + 1 < letters.Length && char.IsSurrogatePair(letters[i], letters[i + 1])) i++;
                else letters[i] = '\uFFFD';
            }
        }

        static char Escaped(ReadOnlySpan<byte> escape)
        {
            switch ((char)escape[1])
            {
                case 'b': return '\b';
                case 'f': return '\f';
                case 'n': return '\n';
                case 'r': return '\r';
                case 't': return '\t';
                case 'u': return (char)(HexDigit(escape[2]) << 12 | HexDigit(escape[3]) << 8 | HexDigit(escape[4]) << 4 | HexDigit(escape[5]));
                default: return (char)escape[1];
            }
        }

        // Returns 0 if there is no valid escape.
        static int EscapeLength(ReadOnlySpan<byte> text)
        {
            if (text.Length < 2) return 0;
            if (text[1] != 'u') return "\"\\/bfnrt".IndexOf((char)text[1]) < 0 ? 0 : 2;
            if (text.Length < 6) return 0;
            for (var i = 2; i < 6; i++)
                if (HexDigit(text[i]) < 0) return 0;
            return 6;
        }

        static int HexDigit(byte digit)
        {
            if (digit >= '0' && digit <= '9') return digit - '0';
            var letter = digit | 0x20;
            return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : -1;
        }

        // Table 3-7 of Unicode: no overlong forms, no surrogates, nothing above U+10FFFF. Returns 0 for an invalid sequence.
        static int SequenceLength(ReadOnlySpan<byte> text)
        {
            var first = text[0];
            if (first < 0xC2 || first > 0xF4) return 0;
            var length = first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
            if (text.Length < length) return 0;
            var min = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
            var max = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
            if (text[1] < min || text[1] > max) return 0;
            for (var i = 2; i < length; i++)
                if ((text[i] & 0xC0) != 0x80) return 0;
            return length;
        }
    }
}
