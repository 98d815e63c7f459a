using System;

namespace Nowpose.Protocol
{
    /// <summary>
    /// Reads one JSON object from UTF-8 in a single pass, and checks grammar, encoding and nesting at the same time. <see cref="Fault"/> is
    /// the first violation. Allocates only the strings that a caller requests.
    /// </summary>
    /// <remarks>
    /// No available library is suitable: Newtonsoft's JsonTextReader reads characters, creates a string for each name and number, and accepts
    /// comments, single quotes and trailing commas; System.Text.Json is not in Unity 2021.3. Newtonsoft.Json is used only for writing.
    /// NaN, Infinity and -Infinity are accepted as numbers, because real robots send them in fields that are not read; the reader of each
    /// field checks them. After a fault, loops over fields and elements end, so a caller checks <see cref="Fault"/> once at the end.
    /// </remarks>
    ref struct JsonUtf8Reader
    {
        readonly ReadOnlySpan<byte> _text;
        readonly int _maxDepth;
        int _at;
        int _depth;
        bool _isFirst;

        /// <param name="maxDepth">Maximum nesting; the outermost object is level 1.</param>
        public JsonUtf8Reader(ReadOnlySpan<byte> text, int maxDepth)
        {
            _text = text;
            _maxDepth = maxDepth;
            _at = 0;
            _depth = 0;
            _isFirst = false;
            Fault = DropReason.None;
            SkipBlanks();
        }

        public DropReason Fault { get; private set; }

        public bool IsObject => Peek() == '{';
        public bool IsText => Peek() == '"';
        public bool IsNumber => IsDigit(Peek()) || Peek() == '-' || Peek() == 'N' || Peek() == 'I';

        /// <summary>Whether the next value is a number without fraction and exponent.</summary>
        public bool IsInteger
        {
            get
            {
                var ahead = this;
                return ahead.ScanNumber(out var number) && number.IsInteger;
            }
        }

        /// <summary>Number of bytes read so far.</summary>
        public int Position => _at;

        /// <summary>Checks that the input is exactly one JSON object within the maximum nesting.</summary>
        public static DropReason Check(ReadOnlySpan<byte> text, int maxDepth)
        {
            var json = new JsonUtf8Reader(text, maxDepth);
            if (!json.IsObject) return DropReason.NotJson;
            json.Skip();
            json.End();
            return json.Fault;
        }

        public bool Fail(DropReason reason)
        {
            if (Fault == DropReason.None) Fault = reason;
            return false;
        }

        /// <summary>Requires the end of the input.</summary>
        public bool End()
        {
            SkipBlanks();
            return Fault == DropReason.None && (_at == _text.Length || Fail(DropReason.NotJson));
        }

        public bool BeginObject() => Begin('{');

        public bool BeginArray() => Begin('[');

        /// <summary>Advances to the value of the next known field; skips unknown fields. Returns false at the end of the object.</summary>
        /// <param name="seen">Bit mask of the fields found so far; initially 0.</param>
        public bool NextField(JsonNames known, ref int seen, out int field)
        {
            field = -1;
            while (Fault == DropReason.None && Next('}'))
            {
                if (!FieldName(out var name)) return false;
                field = name.IsEscaped ? known.IndexOf(name.Unescaped()) : known.IndexOf(name.Raw);
                if (field < 0)
                {
                    Skip();
                    continue;
                }

                var isTwice = (seen & (1 << field)) != 0;
                seen |= 1 << field;
                return !isTwice || Fail(DropReason.DuplicateField);
            }

            return false;
        }

        /// <summary>Advances to the value of the next field with any name. Returns false at the end of the object.</summary>
        public bool NextField(out string name)
        {
            name = null;
            if (Fault != DropReason.None || !Next('}') || !FieldName(out var text)) return false;
            name = text.ToString();
            return true;
        }

        /// <param name="required">Bit mask of the required fields.</param>
        public bool EndObject(int seen, int required) =>
            Fault == DropReason.None && ((seen & required) == required || Fail(DropReason.MissingField));

        /// <summary>Advances to the next element. Returns false at the end of the array.</summary>
        public bool NextElement() => Fault == DropReason.None && Next(']');

        /// <summary>Skips a value of any type.</summary>
        public bool Skip()
        {
            switch ((char)Peek())
            {
                case '{':
                    Begin('{');
                    while (Fault == DropReason.None && Next('}') && FieldName(out _)) Skip();
                    break;
                case '[':
                    Begin('[');
                    while (NextElement()) Skip();
                    break;
                case '"': ScanText(out _); break;
                case 't': Require(Literal("true")); break;
                case 'f': Require(Literal("false")); break;
                case 'n': Require(Literal("null")); break;
                default: Require(NotFinite(out _) || ScanNumber(out _)); break;
            }

            return Fault == DropReason.None;
        }

        /// <summary>Skips a value if the next bytes are equal to the bytes of an earlier value.</summary>
        public bool TryTake(ReadOnlySpan<byte> value)
        {
            if (!_text.Slice(_at).StartsWith(value)) return false;
            _at += value.Length;
            return true;
        }

        /// <summary>Returns the bytes read since a position.</summary>
        public ReadOnlySpan<byte> Since(int position) => _text.Slice(position, _at - position);

        public bool TakeNull() => Literal("null");

        public bool Text(out string text)
        {
            var isRead = ReadText(out var read);
            text = isRead ? read.ToString() : null;
            return isRead;
        }

        /// <summary>Reads a string. Creates no string object for a known string.</summary>
        /// <param name="index">Index of a known string; -1 for any other string.</param>
        public bool Text(JsonNames known, out int index, out string text)
        {
            index = -1;
            text = null;
            if (!ReadText(out var read)) return false;
            index = known.IndexOf(read.Raw);
            text = index < 0 ? read.ToString() : known[index];
            if (read.IsEscaped) index = known.IndexOf(read.Unescaped());
            return true;
        }

        public bool Flag(out bool value)
        {
            value = Literal("true");
            return value || Literal("false") || Fail(DropReason.WrongType);
        }

        public bool Integer(out long value)
        {
            value = 0;
            if (!IsNumber || NotFinite(out _)) return Fail(DropReason.WrongType);
            if (!ScanNumber(out var number)) return false;
            return number.IsInteger ? number.TryGetInteger(out value) || Fail(DropReason.OutOfRange) : Fail(DropReason.WrongType);
        }

        /// <summary>Reads a number. Null is read as NaN, because rosbridge writes null for a number that is not finite.</summary>
        public bool Number(out double value)
        {
            if (NotFinite(out value)) return true;
            if (!IsNumber) return TakeNull() || Fail(DropReason.WrongType);
            if (!ScanNumber(out var number)) return false;
            value = number.ToDouble();
            return true;
        }

        static bool IsDigit(byte value) => value >= '0' && value <= '9';

        bool Begin(char start)
        {
            if (!Take(start)) return Fail(DropReason.WrongType);
            _isFirst = true;
            return ++_depth <= _maxDepth || Fail(DropReason.TooDeep);
        }

        // Advances to the next name or element; returns false after the end.
        bool Next(char end)
        {
            SkipBlanks();
            var isFirst = _isFirst;
            _isFirst = false;
            if (Take(end))
            {
                _depth--;
                return false;
            }

            if (!isFirst && !Take(',')) return Fail(DropReason.NotJson);
            SkipBlanks();
            return true;
        }

        bool FieldName(out JsonText name)
        {
            if (!ScanText(out name)) return false;
            SkipBlanks();
            if (!Take(':')) return Fail(DropReason.NotJson);
            SkipBlanks();
            return true;
        }

        /// <summary>Reads a string without creating a string object.</summary>
        public bool ReadText(out JsonText text)
        {
            text = default;
            return IsText ? ScanText(out text) : Fail(DropReason.WrongType);
        }

        bool ScanText(out JsonText text)
        {
            text = default;
            if (!Take('"')) return Fail(DropReason.NotJson);
            if (!JsonText.TryScan(_text.Slice(_at), out text)) return Fail(DropReason.NotJson);
            _at += text.Raw.Length + 1;
            return true;
        }

        bool ScanNumber(out JsonNumber number)
        {
            if (!JsonNumber.TryScan(_text.Slice(_at), out number)) return Fail(DropReason.NotJson);
            _at += number.Length;
            return true;
        }

        bool NotFinite(out double value)
        {
            value = double.NaN;
            if (Literal("NaN")) return true;
            value = double.PositiveInfinity;
            if (Literal("Infinity")) return true;
            value = double.NegativeInfinity;
            if (Literal("-Infinity")) return true;
            value = double.NaN;
            return false;
        }

        bool Literal(string word)
        {
            if (_text.Length - _at < word.Length) return false;
            for (var i = 0; i < word.Length; i++)
                if (_text[_at + i] != word[i]) return false;
            _at += word.Length;
            return true;
        }

        void Require(bool isValid)
        {
            if (!isValid) Fail(DropReason.NotJson);
        }

        bool Take(char c)
        {
            if (Peek() != c) return false;
            _at++;
            return true;
        }

        // Returns zero at the end of the input, and for a zero byte in the input, which is never valid.
        byte Peek() => _at < _text.Length ? _text[_at] : (byte)0;

        void SkipBlanks()
        {
            while (Peek() == ' ' || Peek() == '\t' || Peek() == '\n' || Peek() == '\r') _at++;
        }
    }
}
