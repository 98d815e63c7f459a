using System;

namespace Nowpose.Protocol
{
    /// <summary>Whether a text is exactly one JSON object, no deeper than allowed. Allocates nothing; recurses as deep as allowed.</summary>
    /// <remarks>
    /// Goes before Newtonsoft's reader, which lets comments, single quotes, bare names, trailing commas, hexadecimal numbers and
    /// constructors pass. NaN, Infinity and -Infinity pass here too: real robots send them in fields nobody reads, so the
    /// reader of each field judges them.
    /// </remarks>
    ref struct JsonSyntax
    {
        readonly ReadOnlySpan<char> _text;
        readonly int _maxDepth;
        int _at;
        int _depth;
        bool _isTooDeep;

        JsonSyntax(ReadOnlySpan<char> text, int maxDepth)
        {
            _text = text;
            _maxDepth = maxDepth;
            _at = 0;
            _depth = 0;
            _isTooDeep = false;
        }

        /// <param name="maxDepth">The outermost object is level 1.</param>
        public static DropReason Check(string text, int maxDepth)
        {
            var syntax = new JsonSyntax(text.AsSpan(), maxDepth);
            if (syntax.Document())
                return DropReason.None;
            return syntax._isTooDeep ? DropReason.TooDeep : DropReason.NotJson;
        }

        bool Document()
        {
            SkipBlanks();
            if (Peek() != '{' || !Value())
                return false;
            SkipBlanks();
            return _at == _text.Length;
        }

        bool Value()
        {
            SkipBlanks();
            if (Take('{'))
                return Container('}');
            return Take('[') ? Container(']') : Scalar();
        }

        bool Container(char end)
        {
            _isTooDeep = ++_depth > _maxDepth;
            if (_isTooDeep)
                return false;
            SkipBlanks();
            var isValid = Take(end) || (Members(end == '}') && Take(end));
            _depth--;
            return isValid;
        }

        bool Members(bool areNamed)
        {
            do
            {
                if ((areNamed && !Name()) || !Value())
                    return false;
                SkipBlanks();
            }
            while (Take(','));
            return true;
        }

        bool Name()
        {
            SkipBlanks();
            if (!QuotedText())
                return false;
            SkipBlanks();
            return Take(':');
        }

        bool Scalar()
        {
            switch (Peek())
            {
                case '"': return QuotedText();
                case 't': return Literal("true");
                case 'f': return Literal("false");
                case 'n': return Literal("null");
                case 'N': return Literal("NaN");
                case 'I': return Literal("Infinity");
                default: return Literal("-Infinity") || Number();
            }
        }

        bool QuotedText()
        {
            if (!Take('"'))
                return false;
            while (_at < _text.Length)
            {
                var c = _text[_at++];
                if (c == '"')
                    return true;
                if (c < ' ' || (c == '\\' && !Escape()))
                    return false;
            }

            return false;
        }

        bool Escape()
        {
            var c = Peek();
            _at++;
            if (c != 'u')
                return c != '\0' && "\"\\/bfnrt".Contains(c);
            for (var i = 0; i < 4; i++, _at++)
            {
                if (!Uri.IsHexDigit(Peek()))
                    return false;
            }

            return true;
        }

        bool Number()
        {
            Take('-');
            if (!Take('0') && !Digits())
                return false;
            if (Take('.') && !Digits())
                return false;
            if (!Take('e') && !Take('E'))
                return true;
            if (!Take('+'))
                Take('-');
            return Digits();
        }

        bool Digits()
        {
            var start = _at;
            while (Peek() >= '0' && Peek() <= '9')
                _at++;
            return _at > start;
        }

        bool Literal(string word)
        {
            if (!_text.Slice(_at).StartsWith(word.AsSpan(), StringComparison.Ordinal))
                return false;
            _at += word.Length;
            return true;
        }

        bool Take(char c)
        {
            if (Peek() != c || _at >= _text.Length)
                return false;
            _at++;
            return true;
        }

        char Peek() => _at < _text.Length ? _text[_at] : '\0';

        void SkipBlanks()
        {
            while (Peek() == ' ' || Peek() == '\t' || Peek() == '\n' || Peek() == '\r')
                _at++;
        }
    }
}
